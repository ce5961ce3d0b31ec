/* SPDX-License-Identifier: MIT */
/* json_value FILE [KEY...]: refuses what is not strict JSON; prints the value at the keys (an array
 * takes an index). Objects and arrays print their number of members. */
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    json_error_t error;
    if (argc < 2) return 2;
    json_t *root = json_load_file(argv[1], JSON_REJECT_DUPLICATES, &error);
    if (!root) {
        fprintf(stderr, "%s:%d: %s\n", argv[1], error.line, error.text);
        return 1;
    }
    const json_t *value = root;
    for (int i = 2; i < argc && value; i++)
        value = json_is_array(value) ? json_array_get(value, (size_t)strtoul(argv[i], NULL, 10))
                                     : json_object_get(value, argv[i]);
    if (!value)
        fputs("absent\n", stdout);
    else if (json_is_string(value))
        printf("%s\n", json_string_value(value));
    else if (json_is_integer(value))
        printf("%lld\n", (long long)json_integer_value(value));
    else if (json_is_real(value))
        printf("%.17g\n", json_real_value(value));
    else if (json_is_boolean(value))
        printf("%s\n", json_is_true(value) ? "true" : "false");
    else if (json_is_null(value))
        fputs("null\n", stdout);
    else
        printf("%zu\n", json_is_array(value) ? json_array_size(value) : json_object_size(value));
    json_decref(root);
    return 0;
}
