/* The words of a formula's text. */
#ifndef MATC_FORMULA_LEX_H
#define MATC_FORMULA_LEX_H
#include "compiler/formula/formula.h"
#include <string.h>

typedef enum {
    TOKEN_end,
    TOKEN_number, /* number */
    TOKEN_color,  /* lanes of color */
    TOKEN_name,
    TOKEN_text,   /* in quotes, of either kind, which belong to it */
    TOKEN_symbol, /* operators, brackets, and , ; = ? : . */
    TOKEN_other,  /* a character that no formula has; a number or a colour that is none */
} TokenKind;

typedef struct {
    TokenKind kind;
    uint32_t start, end; /* bytes */
    int symbol;          /* the first of symbol_table that it is; symbol_count: it is none */
    double number;
    int lanes;
    double color[4];
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
/* Whether the token is this symbol. */
static inline bool formula_token_is(const FormulaSource *source, const Token *token, const char *symbol)
{
    const size_t size = strlen(symbol);
    return token->kind == TOKEN_symbol && formula_token_size(*token) == size &&
           !memcmp(source->text + token->start, symbol, size);
}
/* For messages: 'sin', or the end of the formula. */
const char *formula_token_text(const FormulaSource *source, Token token);
/* "; here it is mix(a, b, share)": of a name that nothing has. NULL: it is not known from anywhere else. formula_foreign.c */
const char *formula_foreign(Session *session, const char *name);
#endif
