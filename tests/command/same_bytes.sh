# SPDX-License-Identifier: MIT
# Same scenario and seed, same bytes: for any number of threads and every instruction set.
. "$COMMAND_TESTS/lib.sh"
small_scenario >mission.yaml
result() { # result DIR SWITCH...
    dir=$1
    shift
    "$SCHULER" run mission.yaml --quiet --json "$dir.json" -o "$dir" "$@" || complain "run $*"
}
result first --threads 1
[ "$(wc -l <first/errors.csv)" -gt 100 ] || complain "errors.csv has only $(wc -l <first/errors.csv) lines"
again() { # again DIR SWITCH...
    result "$@"
    same first.json "$1.json"
    same first/errors.csv "$1/errors.csv"
    same first/budget.csv "$1/budget.csv"
    same first/result.nc "$1/result.nc"
}
again repeated --threads 1
again threads2 --threads 2
again threads3 --threads 3
again all_threads --threads 0
for isa in scalar sse2 avx2 avx512; do
    if "$SCHULER" run mission.yaml -q --runs 1 --isa $isa >out 2>err; then
        again isa_$isa --isa $isa --threads 2
    else
        grep -q "does not have $isa" err || complain "--isa $isa: $(cat err)"
    fi
done
result other --seed 8
differ first.json other.json
differ first/errors.csv other/errors.csv
differ first/result.nc other/result.nc
# Whatever the memory held, also that of the libraries.
MALLOC_PERTURB_=165
export MALLOC_PERTURB_
again perturbed
unset MALLOC_PERTURB_

# A source alone draws what it draws in company.
result alone --only gyro.bias
for d in first alone; do grep '^gyro.bias,' $d/errors.csv >$d.gyro; done
same first.gyro alone.gyro
[ -s alone.gyro ] || complain "no rows of gyro.bias"
finish
