/* Parser state shared by the parts of the formula parser: the operand and operator stacks. */
#ifndef MATC_FORMULA_READER_H
#define MATC_FORMULA_READER_H
#include "compiler/formula/formula_lex.h"

enum { FORMULA_MAX_FAULTS = 8, FORMULA_MAX_COMPONENTS = 4 };

/* An entry of the operator stack: an operator, an open bracket, or half of a conditional. */
typedef enum {
    WAIT_infix,
    WAIT_prefix,
    WAIT_question,
    WAIT_colon,
    WAIT_group,
    WAIT_list,
    WAIT_call
} FormulaWaitKind;
typedef struct {
    FormulaWaitKind kind;
    OperatorLevel level;
    int row;     /* a Term; for WAIT_list the width; 0: the width of the parts */
    size_t base; /* number of operands before the construct */
    uint32_t start, end;
} FormulaWait;

typedef struct {
    const FormulaSource *s;
    Session *session;
    Formula *f;
    Token token; /* the next token */
    uint32_t *operands;
    size_t operand_count, operand_capacity;
    FormulaWait *waits;
    size_t wait_count, wait_capacity;
    Names locals;
    uint32_t *local_steps; /* step of each local */
    size_t local_count, local_capacity;
    int faults;
    bool in_local; /* the reader is within a local's value, which ends with ';' */
} FormulaReader;

static inline Span formula_span(const FormulaReader *r, uint32_t start, uint32_t end)
{
    return r->s->span(r->s->user, start, end);
}
static inline Span formula_token_span(const FormulaReader *r)
{
    return formula_span(r, r->token.start, r->token.end);
}
static inline void formula_next(FormulaReader *r) { r->token = formula_token(r->s, r->token.end); }
static inline bool formula_is(const FormulaReader *r, const char *symbol)
{
    return formula_token_is(&r->token, symbol);
}
static inline const char *formula_word(const FormulaReader *r, Token token)
{
    return arena_string(r->session->arena, r->s->text + token.start, formula_token_size(token));
}
/* Reports a fault at the current token. */
void formula_report(FormulaReader *r, DiagKind kind);
/* Reports a character that no formula has, or a number outside a float's range. formula_other.c */
void formula_report_other(FormulaReader *r);
static inline bool formula_is_large(const FormulaReader *r)
{
    const char c = r->s->text[r->token.start];
    return r->token.kind == TOKEN_other && (text_is_digit(c) || c == '.');
}
/* Reports and skips letters that directly follow a number, as in 0.5f, 2u, 45deg. Returns false
 * if there are none. */
bool formula_read_suffix(FormulaReader *r);
/* Reports and skips the next token if it is a decimal comma, as in 0,5. Returns false for
 * another comma. */
bool formula_report_decimal(FormulaReader *r);
/* Reports and skips `return` at the beginning of a part. */
void formula_pass_return(FormulaReader *r);
/* Skips an invalid token; a comment of another language is skipped to the end of its line. */
void formula_pass_other(FormulaReader *r);
/* Reports `if c then a else b` and replaces it by a faulty operand. Returns false if the token
 * starts no such construct. */
bool formula_read_if(FormulaReader *r);

void formula_push(FormulaReader *r, uint32_t step);
void formula_push_step(FormulaReader *r, FormulaStep step);
void formula_push_fault(FormulaReader *r);
void formula_wait(FormulaReader *r, FormulaWait wait);
static inline FormulaWait *formula_top(const FormulaReader *r)
{
    return r->wait_count ? &r->waits[r->wait_count - 1] : NULL;
}
static inline bool formula_is_open(const FormulaWait *wait) { return wait->kind >= WAIT_group; }
/* Pops `count` operands as the arguments of a step, and pushes the step. */
void formula_apply(FormulaReader *r, FormulaStep step, size_t count);
/* Applies the operator on top of the stack. */
void formula_reduce(FormulaReader *r);
/* Applies stacked operators that bind tighter than the level; with `from_left` also those that
 * bind equally. */
void formula_reduce_to(FormulaReader *r, OperatorLevel level, bool from_left);
/* Parses an operand. Returns false if an operand is still expected. formula_operand.c */
bool formula_operand(FormulaReader *r);
/* Parses attribute(...) from its bracket on. formula_attribute.c */
void formula_read_attribute(FormulaReader *r, Token name);
/* Parses what follows an operand. Returns false if an operand is expected next. *ended: the
 * value is complete. formula_operator.c */
bool formula_operator(FormulaReader *r, bool *ended);
#endif
