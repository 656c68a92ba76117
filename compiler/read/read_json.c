/* Recursive-descent parser: JSON -> Tree, strictly by RFC 8259, with the position of every value
 * and of the first invalid byte. Each grammar rule is a function. A string is scanned first to
 * measure it, then decoded. */
#include "compiler/read/read.h"
#include "compiler/base/text.h"
#include <string.h>

typedef struct {
    TreeBuilder *b;
    const char *text, *at, *end;
} Json;

enum {
    SURROGATE = 0xD800,
    LOW_SURROGATE = 0xDC00,
    SURROGATE_END = 0xE000,
    SUPPLEMENTARY = 0x10000
};

static Span span_of(const Json *j, const char *from, const char *to)
{
    return (Span){(uint32_t)(from - j->text), (uint32_t)(to - j->text), j->b->file};
}

/* Returns the end of the word, number or character at `at`. */
static const char *token_end(const Json *j, const char *at)
{
    const char *from = at;
    while (at < j->end && (text_is_alphanumeric(*at) || (*at && strchr("_+-.", *at))))
        at++;
    return at > from || at == j->end
               ? at
               : at + text_utf8_length((const unsigned char *)at, (const unsigned char *)j->end);
}

/* Reports a syntax error: the grammar expects `wanted`, but another token was found. Always
 * returns NULL. */
static void *wants(const Json *j, const char *at, const char *wanted)
{
    Text found = text_new(j->b->session->arena);
    const char *end = token_end(j, at);
    if (at == j->end)
        text_put(&found, "the end of the file");
    else if ((unsigned char)*at < 0x20 || *at == 0x7F)
        text_format(&found, "the control character U+%04X", *at);
    else
        text_format(&found, "'%.*s'", end - at < LIMIT_NAME ? (int)(end - at) : LIMIT_NAME, at);
    return diag_add(j->b->session, span_of(j, at, end > at ? end : at + 1), DIAG_json_wants, wanted,
                    found.at);
}

static void *has_no(const Json *j, const char *at, const char *end, const char *what)
{
    return diag_add(j->b->session, span_of(j, at, end), DIAG_json_has_no, what);
}

static void skip_space(Json *j)
{
    while (j->at < j->end && (*j->at == ' ' || *j->at == '\t' || *j->at == '\n' || *j->at == '\r'))
        j->at++;
}

static bool is_digit(const Json *j, const char *at)
{
    return at < j->end && *at >= '0' && *at <= '9';
}

/* digit+; reports a missing digit and returns false. */
static bool skip_digits(Json *j)
{
    if (!is_digit(j, j->at))
        return wants(j, j->at, "a digit");
    while (is_digit(j, j->at))
        j->at++;
    return true;
}

/* Scans a number: -? (0 | [1-9] digit*) (. digit+)? ([eE] [+-]? digit+)? */
static bool skip_number(Json *j)
{
    j->at += *j->at == '-';
    if (*j->at == '0' && is_digit(j, j->at + 1))
        return has_no(j, j->at, j->at + 1, "leading zeros in numbers");
    if (!skip_digits(j))
        return false;
    if (*j->at == '.') {
        j->at++;
        if (!skip_digits(j))
            return false;
    }
    if (*j->at == 'e' || *j->at == 'E') {
        j->at++;
        j->at += *j->at == '+' || *j->at == '-';
        return skip_digits(j);
    }
    return true;
}

/* Parses the four digits of \uXXXX at `at`; -1 if they are invalid. */
static int32_t hex_code(const Json *j, const char *at)
{
    int32_t code = 0;
    for (int i = 0; i < 4; i++, at++) {
        const int digit = at < j->end ? text_hex_digit(*at) : -1;
        if (digit < 0)
            return -1;
        code = code * 16 + digit;
    }
    return code;
}

/* Decodes the escape at `at` and returns its code point and size. A surrogate pair of two
 * escapes such as U+D83D and U+DE00 is one character, U+1F600: (0xD83D - 0xD800) << 10 | (0xDE00
 * - 0xDC00), plus 0x10000. Returns -1 for an invalid escape or half of a pair. */
static int32_t read_escape(const Json *j, const char *at, int *size)
{
    static const char letters[] = "\"\\/bfnrt", meaning[] = "\"\\/\b\f\n\r\t";
    const char *letter = at + 1 < j->end && at[1] ? strchr(letters, at[1]) : NULL;
    *size = letter ? 2 : 6;
    if (letter)
        return (unsigned char)meaning[letter - letters];
    int32_t code = at + 1 < j->end && at[1] == 'u' ? hex_code(j, at + 2) : -1;
    if (code < SURROGATE || code >= SURROGATE_END)
        return code;
    int32_t low = j->end - at >= 12 && at[6] == '\\' && at[7] == 'u' ? hex_code(j, at + 8) : -1;
    if (code >= LOW_SURROGATE || low < LOW_SURROGATE || low >= SURROGATE_END)
        return -1;
    *size = 12;
    return ((code - SURROGATE) << 10 | (low - LOW_SURROGATE)) + SUPPLEMENTARY;
}

static void *bad_escape(const Json *j, const char *at)
{
    if (at + 1 < j->end && at[1] == 'u' && hex_code(j, at + 2) >= 0)
        return has_no(j, at, at + 6, "unpaired surrogates");
    const char *end = at + 1 < j->end ? token_end(j, at + 1) : at + 1;
    Text what = text_new(j->b->session->arena);
    text_format(&what, "escape '%.*s'", end - at < 8 ? (int)(end - at) : 8, at);
    return has_no(j, at, end, what.at);
}

static int utf8_size(int32_t code)
{
    return code < 0x80 ? 1 : code < 0x800 ? 2 : code < SUPPLEMENTARY ? 3 : 4;
}

static char *put_utf8(char *to, int32_t code)
{
    static const unsigned char first[] = {0, 0, 0xC0, 0xE0, 0xF0};
    const int size = utf8_size(code);
    for (int i = size - 1; i > 0; i--, code >>= 6)
        to[i] = (char)(0x80 | (code & 0x3F));
    to[0] = (char)(first[size] | code);
    return to + size;
}

static bool open_text(const Json *j, const char *from)
{
    wants(j, j->end, "'\"'");
    return diag_add(j->b->session, span_of(j, from, from + 1), DIAG_json_open);
}

/* Scans the string whose opening quote is at j->at; *size is its decoded size in bytes. */
static bool measure_text(Json *j, size_t *size)
{
    const char *from = j->at++;
    for (*size = 0; j->at < j->end && *j->at != '"';) {
        int escape = 1;
        int32_t code = 0;
        if ((unsigned char)*j->at < 0x20)
            return wants(j, j->at, "an escape such as \\n or \\u0001");
        if (*j->at == '\\' && (code = read_escape(j, j->at, &escape)) < 0)
            return bad_escape(j, j->at);
        *size += (size_t)utf8_size(code);
        j->at += escape;
    }
    if (j->at == j->end)
        return open_text(j, from);
    j->at++;
    return true;
}

static void write_text(const Json *j, const char *at, char *to)
{
    while (*at != '"') {
        int escape = 1;
        if (*at == '\\')
            to = put_utf8(to, read_escape(j, at, &escape));
        else
            *to++ = *at;
        at += escape;
    }
}

/* string: " (character | escape)* " */
static const char *read_text(Json *j, uint32_t *size)
{
    const char *from = j->at;
    size_t bytes;
    if (!measure_text(j, &bytes))
        return NULL;
    char *text = tree_build_text(j->b, bytes);
    write_text(j, from + 1, text);
    tree_build_check_text(j->b, text, bytes, span_of(j, from, j->at));
    *size = (uint32_t)bytes;
    return text;
}

static Tree *read_scalar(Json *j, const char *from, const char *text, uint32_t size, bool plain)
{
    Tree *scalar = tree_build_value(j->b, TREE_scalar, span_of(j, from, j->at));
    if (!scalar)
        return NULL;
    scalar->text = text ? text : memcpy(tree_build_text(j->b, size), from, size);
    scalar->count = size;
    scalar->plain = plain;
    return scalar;
}

static Tree *read_quoted(Json *j)
{
    const char *from = j->at;
    uint32_t size;
    const char *text = read_text(j, &size);
    return text ? read_scalar(j, from, text, size, false) : NULL;
}

static Tree *read_number(Json *j)
{
    const char *from = j->at;
    return skip_number(j) ? read_scalar(j, from, NULL, (uint32_t)(j->at - from), true) : NULL;
}

/* true, false or null; any other word is an error. */
static Tree *read_word(Json *j)
{
    static const char *const words[] = {"true", "false", "null"};
    const char *from = j->at, *end = token_end(j, from);
    for (int i = 0; i < 3; i++)
        if ((size_t)(end - from) == strlen(words[i]) && !memcmp(from, words[i], strlen(words[i]))) {
            j->at = end;
            return read_scalar(j, from, NULL, (uint32_t)(end - from), true);
        }
    if (from < j->end && (*from == '/' || *from == '#'))
        return has_no(j, from, from + 1, "comments");
    if (from < j->end && *from == '\'')
        return has_no(j, from, from + 1, "strings in single quotes");
    return wants(j, from, "a value");
}

/* Reads the separator after an item or member; `close` ends the collection. Returns 1 for a
 * comma, 0 for the end, -1 for a fault. */
static int next_part(Json *j, Span whole, char close)
{
    skip_space(j);
    const char *comma = j->at;
    if (j->at < j->end && *j->at == close) {
        j->at++;
        return 0;
    }
    if (j->at == j->end || *j->at != ',') {
        if (j->at < j->end && (*j->at == '/' || *j->at == '#'))
            has_no(j, j->at, j->at + 1, "comments");
        else
            wants(j, j->at, close == ']' ? "',' or ']'" : "',' or '}'");
        if (j->at == j->end)
            diag_add(j->b->session, (Span){whole.start, whole.start + 1, whole.file},
                     DIAG_json_open);
        return -1;
    }
    j->at++;
    skip_space(j);
    if (j->at == j->end || *j->at != close)
        return 1;
    has_no(j, comma, comma + 1, close == ']' ? "comma before ']'" : "comma before '}'");
    return -1;
}

static bool at_end_of_empty(Json *j, char close)
{
    skip_space(j);
    bool empty = j->at < j->end && *j->at == close;
    j->at += empty;
    return empty;
}

static Tree *read_value(Json *j, int depth);

/* Parses a list: [ (value (, value)*)? ] */
static bool read_list(Json *j, Tree *list, int depth)
{
    const size_t from = j->b->item_count;
    int more = !at_end_of_empty(j, ']');
    while (more > 0) {
        Tree *item = read_value(j, depth + 1);
        if (!item)
            return false;
        tree_build_item(j->b, item);
        more = next_part(j, list->span, ']');
    }
    tree_build_list(j->b, list, from);
    return more == 0;
}

/* member: string : value */
static bool read_member(Json *j, int depth)
{
    Member member;
    const char *from = j->at;
    if (from < j->end && *from == '\'')
        return has_no(j, from, from + 1, "strings in single quotes");
    if (from == j->end || *from != '"')
        return wants(j, from, "a key in double quotes");
    if (!(member.key = read_text(j, &member.size)))
        return false;
    member.span = span_of(j, from, j->at);
    skip_space(j);
    if (j->at == j->end || *j->at != ':')
        return wants(j, j->at, "':'");
    j->at++;
    if (!(member.value = read_value(j, depth + 1)))
        return false;
    tree_build_member(j->b, member);
    return true;
}

/* Parses an object: { (member (, member)*)? } */
static bool read_object(Json *j, Tree *object, int depth)
{
    const size_t from = j->b->member_count;
    int more = !at_end_of_empty(j, '}');
    while (more > 0) {
        if (!read_member(j, depth))
            return false;
        more = next_part(j, object->span, '}');
    }
    tree_build_object(j->b, object, from);
    return more == 0;
}

static Tree *read_collection(Json *j, TreeKind kind, int depth)
{
    const char *from = j->at++;
    if (depth > LIMIT_DEPTH)
        return diag_add(j->b->session, span_of(j, from, j->at), DIAG_too_deep, LIMIT_DEPTH);
    Tree *tree = tree_build_value(j->b, kind, span_of(j, from, j->at));
    if (!tree || !(kind == TREE_list ? read_list(j, tree, depth) : read_object(j, tree, depth)))
        return NULL;
    tree->span.end = (uint32_t)(j->at - j->text);
    return tree;
}

/* value: object | list | string | number | word */
static Tree *read_value(Json *j, int depth)
{
    skip_space(j);
    const char first = j->at < j->end ? *j->at : 0;
    if (first == '{')
        return read_collection(j, TREE_object, depth);
    if (first == '[')
        return read_collection(j, TREE_list, depth);
    if (first == '"')
        return read_quoted(j);
    return first == '-' || is_digit(j, j->at) ? read_number(j) : read_word(j);
}

Tree *read_json(TreeBuilder *b)
{
    const Source *source = &b->session->sources[b->file];
    Json j = {b, source->text, source->text + b->start, source->text + source->size};
    Tree *tree = read_value(&j, 0);
    if (!tree)
        return NULL;
    skip_space(&j);
    if (j.at == j.end)
        return tree;
    return *j.at == '/' || *j.at == '#' ? has_no(&j, j.at, j.at + 1, "comments")
                                        : wants(&j, j.at, "the end of the file");
}
