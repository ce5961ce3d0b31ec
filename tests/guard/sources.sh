# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced by the guards. The project's own files matching a name pattern, relative to the current
# folder. By find, not by git: also in an unpacked archive, and when another user owns the checkout.
our_files() {
    find . -name '.?*' -prune -o -path ./build -prune -o -type f -name "$1" -print | sed 's,^\./,,' | sort
}
