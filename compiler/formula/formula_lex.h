/* The lexer of formulas: splits a text into tokens. */
#ifndef MATC_FORMULA_LEX_H
#define MATC_FORMULA_LEX_H
#include "compiler/formula/formula.h"

typedef enum {
    TOKEN_end,
    TOKEN_number, /* number */
    TOKEN_color,  /* formula_color */
    TOKEN_name,
    TOKEN_text,   /* in quotes, of either kind, which belong to it */
    TOKEN_symbol, /* operators, brackets, and , ; = ? : . */
    TOKEN_other,  /* a character that no formula has; a number or a colour that is none */
} TokenKind;

typedef struct {
    TokenKind kind;
    uint32_t start, end; /* bytes */
    uint16_t mark;       /* formula_mark of a symbol; 0: it is none */
    int symbol;          /* the first of symbol_table that it is; symbol_count: it is none */
    double number;
} Token;

/* The token that begins at that byte or behind the space there. */
Token formula_token(const FormulaSource *source, uint32_t at);
static inline uint32_t formula_token_size(Token token) { return token.end - token.start; }
/* The text goes on with that word at that byte. */
static inline bool formula_begins(const FormulaSource *source, uint32_t at, const char *word)
{
    while (at < source->size && *word && source->text[at] == *word)
        at++, word++;
    return !*word;
}
/* A symbol as one number: no symbol has more than two bytes. */
static inline uint16_t formula_mark(const char *symbol)
{
    return (uint16_t)((uint8_t)symbol[0] | (uint8_t)symbol[1] << 8);
}
static inline bool formula_token_is(const Token *token, const char *symbol)
{
    return token->mark == formula_mark(symbol);
}
/* How many lanes a colour has, and what they are. */
int formula_color(const FormulaSource *source, const Token *token, double color[4]);
/* For messages: 'sin', or the end of the formula. */
const char *formula_token_text(const FormulaSource *source, Token token);
/* "; here it is mix(a, b, share)": of a name that nothing has. NULL: it is not known from anywhere
 * else. formula_foreign.c */
const char *formula_foreign(Session *session, const char *name);
#endif
