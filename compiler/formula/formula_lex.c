/* The lexer of formulas: numbers, colors, names and symbols. The longest token wins: "<=" before
 * "<", "1.5e3" as one number. */
#include "compiler/formula/formula_lex.h"
#include "compiler/library/srgb.h"
#include <math.h>
#include <string.h>

static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
static bool is_word(char c) { return text_is_alphanumeric(c) || c == '_'; }

static uint32_t digits_end(const FormulaSource *s, uint32_t at)
{
    while (at < s->size && text_is_digit(s->text[at]))
        at++;
    return at;
}

/* digits [ "." digits ] [ e [ sign ] digits ]; a lone point is no number. A point followed by
 * letters starts a swizzle. */
static uint32_t number_end(const FormulaSource *s, uint32_t at)
{
    uint32_t end = digits_end(s, at);
    if (end < s->size && s->text[end] == '.' &&
        !(end > at && text_is_letter(s->text[end + 1]) && s->text[end + 1] != 'e'))
        end = digits_end(s, end + 1);
    if (end < s->size && text_lower(s->text[end]) == 'e') {
        uint32_t exponent = end + 1;
        exponent += exponent < s->size && (s->text[exponent] == '-' || s->text[exponent] == '+');
        if (digits_end(s, exponent) > exponent)
            end = digits_end(s, exponent);
    }
    return end;
}

static void read_number(const FormulaSource *s, Token *token)
{
    const char *alone =
        arena_string(s->session->arena, s->text + token->start, formula_token_size(*token));
    token->kind = text_number(alone, formula_token_size(*token), &token->number) &&
                          fabs(token->number) <= 3.4e38
                      ? TOKEN_number
                      : TOKEN_other;
}

/* Returns true for '#' and three, six or eight hexadecimal digits. */
static bool is_color(const FormulaSource *s, const Token *token)
{
    const uint32_t size = formula_token_size(*token) - 1;
    bool digits = size == 3 || size == 6 || size == 8;
    for (uint32_t i = 1; digits && i <= size; i++)
        digits = text_hex_digit(s->text[token->start + i]) >= 0;
    return digits;
}

int formula_color(const FormulaSource *s, const Token *token, double color[4])
{
    const char *digits = s->text + token->start + 1;
    const uint32_t size = formula_token_size(*token) - 1;
    const int each = size == 3 ? 1 : 2, components = size == 8 ? 4 : 3;
    for (int i = 0; i < components; i++)
        color[i] =
            (text_hex_digit(digits[i * each]) * 16 + text_hex_digit(digits[i * each + each - 1])) /
            255.0;
    if (s->color)
        s->color(s->user, token->start, token->end, color);
    for (int i = 0; s->srgb && i < 3; i++)
        color[i] = srgb_decode(color[i]);
    return components;
}

/* Returns true for structural characters, which begin no operator. */
static bool is_structure(char c)
{
    return c == '(' || c == ')' || c == ',' || c == '[' || c == ']' || c == ';' || c == '.' ||
           c == '?' || c == ':';
}

/* Returns the end of a symbol. "**", which other languages use for "^", and "//" are single
 * tokens, so that each is reported once. */
static uint32_t symbol_end(const FormulaSource *s, uint32_t at, int *symbol)
{
    const char c = s->text[at];
    if (is_structure(c))
        return at + 1;
    if (formula_begins(s, at, "**") || formula_begins(s, at, "//"))
        return at + 2;
    *symbol = symbol_begun(s->text + at);
    if (*symbol < symbol_count)
        return at + (symbol_table[*symbol].text[1] ? 2 : 1);
    return c == '=' ? at + 1 : at;
}

/* Returns the end after the closing quote; `at` if there is none. */
static uint32_t text_end(const FormulaSource *s, uint32_t at)
{
    const char *end = memchr(s->text + at + 1, s->text[at], s->size - at - 1);
    return end ? (uint32_t)(end - s->text) + 1 : at;
}

Token formula_token(const FormulaSource *s, uint32_t at)
{
    while (at < s->size && is_space(s->text[at]))
        at++;
    Token token = {.kind = TOKEN_end, .start = at, .end = at, .symbol = symbol_count};
    if (at == s->size)
        return token;
    const char c = s->text[at];
    const unsigned char *bytes = (const unsigned char *)s->text;
    token.end = at + 1;
    if (text_is_digit(c) || (c == '.' && at + 1 < s->size && text_is_digit(s->text[at + 1]))) {
        token.end = number_end(s, at);
        read_number(s, &token);
    } else if (text_is_letter(c) || c == '_' || c == '#') {
        while (token.end < s->size && is_word(s->text[token.end]))
            token.end++;
        token.kind = c != '#' ? TOKEN_name : is_color(s, &token) ? TOKEN_color : TOKEN_other;
    } else if ((c == '"' || c == '\'') && text_end(s, at) > at) {
        token.kind = TOKEN_text;
        token.end = text_end(s, at);
    } else if ((token.end = symbol_end(s, at, &token.symbol)) > at) {
        const char symbol[] = {c, token.end > at + 1 ? s->text[at + 1] : 0};
        const bool foreign = formula_mark(symbol) == formula_mark("**") ||
                             formula_mark(symbol) == formula_mark("//");
        token.kind = foreign ? TOKEN_other : TOKEN_symbol;
        token.mark = foreign ? 0 : formula_mark(symbol);
    } else {
        const int size = text_utf8_length(bytes + at, bytes + s->size);
        token.kind = TOKEN_other;
        token.end = at + (uint32_t)(size > 0 ? size : 1);
    }
    return token;
}

const char *formula_token_text(const FormulaSource *s, Token token)
{
    if (token.kind == TOKEN_end)
        return "the end of the formula";
    const uint32_t size =
        formula_token_size(token) < LIMIT_NAME ? formula_token_size(token) : LIMIT_NAME;
    Text text = text_new(s->session->arena);
    text_format(&text, "'%.*s'", (int)size, s->text + token.start);
    return text.at;
}
