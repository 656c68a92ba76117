/* The lexer of formulas: splits a text into tokens. */
#ifndef MATC_FORMULA_LEX_H
#define MATC_FORMULA_LEX_H
#include "compiler/formula/formula.h"

typedef enum {
    TOKEN_end,
    TOKEN_number, /* literal number, which `number` holds */
    TOKEN_color,  /* hex color, decoded by formula_color() */
    TOKEN_name,
    TOKEN_text,   /* string in single or double quotes, including the quotes */
    TOKEN_symbol, /* operators, brackets, and , ; = ? : . */
    TOKEN_other,  /* invalid character, or malformed number or color */
} TokenKind;

typedef struct {
    TokenKind kind;
    uint32_t start, end; /* byte range of the token in the text */
    uint16_t mark;       /* formula_mark() of a symbol; 0: not a symbol */
    /* first row of the token's symbol in symbol_table; symbol_count: not a symbol */
    int symbol;
    double number;
} Token;

/* Returns the token at this byte or after the white space there. */
Token formula_token(const FormulaSource *source, uint32_t at);
static inline uint32_t formula_token_size(Token token) { return token.end - token.start; }
/* Returns true if the text contains the word at this byte. */
static inline bool formula_begins(const FormulaSource *source, uint32_t at, const char *word)
{
    while (at < source->size && *word && source->text[at] == *word)
        at++, word++;
    return !*word;
}
/* Encodes a symbol of at most two bytes as a number. */
static inline uint16_t formula_mark(const char *symbol)
{
    return (uint16_t)((uint8_t)symbol[0] | (uint8_t)symbol[1] << 8);
}
static inline bool formula_token_is(const Token *token, const char *symbol)
{
    return token->mark == formula_mark(symbol);
}
/* Returns a color's number of components and their values. */
int formula_color(const FormulaSource *source, const Token *token, double color[4]);
/* Returns a token for messages: 'sin', or the end of the formula. */
const char *formula_token_text(const FormulaSource *source, Token token);
/* Returns "; here it is mix(a, b, share)" for a name known from other languages; otherwise NULL.
 * formula_foreign.c */
const char *formula_foreign(Session *session, const char *name);
#endif
