/* The words of a formula's text. */
#ifndef MATC_FORMULA_LEX_H
#define MATC_FORMULA_LEX_H
#include "compiler/formula/formula.h"

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
    double number;
    int lanes;
    double color[4];
} Token;

/* The token that begins at that byte or behind the space there. */
Token formula_token(const FormulaSource *source, uint32_t at);
static inline uint32_t formula_token_size(Token token) { return token.end - token.start; }
/* Whether the token is this symbol. */
bool formula_token_is(const FormulaSource *source, Token token, const char *symbol);
/* For messages: 'sin', or the end of the formula. */
const char *formula_token_text(const FormulaSource *source, Token token);
#endif
