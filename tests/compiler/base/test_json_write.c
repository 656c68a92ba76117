/* Strings of JSON: for any bytes, cJSON reads back the intended text, and no control character
 * is left unescaped. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/base/json_write.h"
#include "compiler/matc.h"
#include <cjson/cJSON.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wchar.h>

enum { CAPACITY = 64 };

/* Length of the character, by the numbers: its first byte says how many more there are, six bits
 * each; the character must need that many, and be one of Unicode's. 0: none. */
static int character(const char *string)
{
    static const long least[] = {0, 0, 0x80, 0x800, 0x10000};
    const unsigned char *at = (const unsigned char *)string;
    const int length = at[0] < 0x80       ? 1
                       : at[0] >> 5 == 6  ? 2
                       : at[0] >> 4 == 14 ? 3
                       : at[0] >> 3 == 30 ? 4
                                          : 0;
    long number = length > 1 ? at[0] & (0x7F >> length) : at[0];
    for (int i = 1; i < length; i++) {
        if (at[i] >> 6 != 2)
            return 0;
        number = number << 6 | (at[i] & 0x3F);
    }
    bool fine = length && number >= least[length] && number <= 0x10FFFF &&
                !(number >= 0xD800 && number < 0xE000);
    return fine ? length : 0;
}

/* The string with U+FFFD for every byte that is no part of a character. */
static void replace_bad(const char *string, char *to)
{
    while (*string) {
        int size = character(string);
        memcpy(to, size ? string : "\xEF\xBF\xBD", size ? (size_t)size : 3);
        to += size ? size : 3;
        string += size ? size : 1;
    }
    *to = 0;
}

/* Characters that a terminal takes for commands, by Unicode's category Cc. */
static bool has_control(const char *text)
{
    wchar_t wide[8 * CAPACITY];
    mbstate_t state = {0};
    size_t size = mbsrtowcs(wide, &text, 8 * CAPACITY, &state);
    assert_true(size < 8 * CAPACITY);
    for (size_t i = 0; i < size; i++)
        if (wide[i] < 0x20 || (wide[i] >= 0x7F && wide[i] < 0xA0))
            return true;
    return false;
}

static void check_string(Arena *arena, const char *string)
{
    char expected[4 * CAPACITY];
    Text text = text_new(arena);
    json_string(&text, string);
    replace_bad(string, expected);
    cJSON *json = cJSON_ParseWithOpts(text.at, NULL, true);
    if (!cJSON_IsString(json) || strcmp(json->valuestring, expected) != 0 || has_control(text.at))
        fail_msg("%s", text.at);
    cJSON_Delete(json);
}

static void test_pairs(void **state)
{
    (void)state;
    for (int first = 1; first < 256; first++) {
        Arena arena = {0};
        for (int second = 1; second < 256; second++)
            check_string(&arena, (char[]){'x', (char)first, (char)second, 'y', 0});
        arena_free(&arena);
    }
}

/* Bytes near the borders of what is UTF-8: U+0080, U+0800, U+10000, surrogates, U+10FFFF. */
static void test_sequences(void **state)
{
    (void)state;
    static const unsigned char bytes[] = {'"',  '\\', 'a',  0x1B, 0x7F, 0x80, 0x8F, 0x90,
                                          0x9B, 0x9F, 0xA0, 0xBF, 0xC1, 0xC2, 0xE0, 0xE2,
                                          0xED, 0xEF, 0xF0, 0xF4, 0xF5, 0xFF};
    const int count = (int)sizeof bytes;
    Arena arena = {0};
    for (int i = 0; i < count * count * count * count; i++) {
        char string[5] = {0};
        for (int k = 0, rest = i; k < 4; k++, rest /= count)
            string[k] = (char)bytes[rest % count];
        check_string(&arena, string);
        if (i % 4096 == 0)
            arena_free(&arena);
    }
    arena_free(&arena);
}

static void test_members(void **state)
{
    (void)state;
    Arena arena = {0};
    Text text = text_new(&arena);
    text_put(&text, "{");
    json_member(&text, "a\"", "b\\");
    json_next(&text, "\x1F", "\xFF");
    text_put(&text, "}");
    assert_string_equal(text.at, "{\"a\\\"\": \"b\\\\\", \"\\u001f\": \"\\ufffd\"}");
    arena_free(&arena);
}

/* Reflection and diagnostics of a document whose name is anything. */
static void test_documents(void **state)
{
    (void)state;
    static const char *const names[] = {"a\"b",
                                        "a\\b",
                                        "a\nb",
                                        "a\x1B[31mb",
                                        "a\x1F",
                                        "\x7F",
                                        "a\xC2\x9B"
                                        "b",
                                        "gr\xFC"
                                        "n",
                                        "\xED\xA0\x80",
                                        "日本"};
    MatcOptions options;
    matc_options_init(&options);
    options.validate = false;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char expected[4 * CAPACITY];
        static const char fine[] = "material: Phong\n", wrong[] = "material: \"\\e\\x9b\\x1f\"\n";
        replace_bad(names[i], expected);
        MatcDocument *document = matc_read(names[i], fine, strlen(fine), &options);
        MatcProgram *program = matc_compile(document, 0, MATC_REFLECT, &options);
        cJSON *json = cJSON_ParseWithOpts(matc_output(program, MATC_REFLECT, NULL), NULL, true);
        assert_non_null(json);
        assert_string_equal(cJSON_GetObjectItem(json, "material")->valuestring, expected);
        assert_string_equal(cJSON_GetObjectItem(json, "sources")->child->valuestring, expected);
        cJSON_Delete(json);
        matc_program_free(program);
        matc_document_free(document);
        document = matc_read(names[i], wrong, strlen(wrong), &options);
        json = cJSON_ParseWithOpts(matc_diagnostics(document, MATC_JSON), NULL, true);
        assert_non_null(json);
        assert_string_equal(cJSON_GetObjectItem(json->child, "file")->valuestring, expected);
        assert_non_null(
            strstr(cJSON_GetObjectItem(json->child, "message")->valuestring, "\x1B\xC2\x9B\x1F"));
        cJSON_Delete(json);
        for (const char *at = matc_diagnostics(document, MATC_TEXT), *end; *at; at = end + 1) {
            char line[CAPACITY * 8];
            end = strchr(at, '\n');
            snprintf(line, sizeof line, "%.*s", (int)(end - at), at);
            assert_false(has_control(line));
        }
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pairs),
        cmocka_unit_test(test_sequences),
        cmocka_unit_test(test_members),
        cmocka_unit_test(test_documents),
    };
    if (!setlocale(LC_ALL, "C.UTF-8"))
        return 77;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
