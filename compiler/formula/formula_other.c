/* Constructs of other languages that formulas lack: each is reported once, with its equivalent,
 * and skipped as a whole. */
#include "compiler/formula/formula_reader.h"
#include "compiler/base/text.h"
#include <string.h>

enum { LONGEST_CHOICE = 120 }; /* max bytes of a conditional that is quoted */

/* A byte range of the text; end 0: the part is missing. */
typedef struct {
    uint32_t start, end;
} Part;

/* Parts of `if CONDITION then YES else NO`, and the token after the construct. */
typedef struct {
    Part condition, yes, no;
    Token behind;
    /* bracketed: the condition begins with a bracket; nested: a part contains an `if` */
    bool bracketed, nested;
} IfParts;

static bool is_called(const FormulaReader *r, const Token *token, const char *word)
{
    return token->kind == TOKEN_name && formula_token_size(*token) == strlen(word) &&
           formula_begins(r->s, token->start, word);
}

static bool begins_value(const Token *token)
{
    return token->kind == TOKEN_number || token->kind == TOKEN_color || token->kind == TOKEN_name ||
           formula_token_is(token, "(");
}

/* Finds the parts, up to the end of the enclosing part of the formula. */
static IfParts find_parts(const FormulaReader *r)
{
    IfParts c = {.behind = formula_token(r->s, r->token.end)};
    Part *part = &c.condition;
    int depth = 0;
    c.bracketed = formula_token_is(&c.behind, "(");
    for (bool closed = false;; c.behind = formula_token(r->s, c.behind.end)) {
        const Token *t = &c.behind;
        const bool opens = formula_token_is(t, "(") || formula_token_is(t, "[");
        const bool closes = formula_token_is(t, ")") || formula_token_is(t, "]");
        if (t->kind == TOKEN_end ||
            (!depth && (closes || formula_token_is(t, ";") || formula_token_is(t, ","))))
            return c;
        const bool yes = !depth && is_called(r, t, "then"), no = !depth && is_called(r, t, "else");
        if (yes || no) {
            part = yes ? &c.yes : &c.no;
            continue;
        }
        if (closed && begins_value(t)) /* the C-like form `if (CONDITION) YES else NO` */
            part = &c.yes;
        part->start = part->end ? part->start : t->start;
        part->end = t->end;
        depth += opens - closes;
        closed = part == &c.condition && c.bracketed && closes && !depth;
        c.nested |= is_called(r, t, "if");
    }
}

/* Returns the construct in the syntax of formulas. */
static const char *choice_text(const FormulaReader *r, const IfParts *c)
{
    const uint32_t start = c->condition.start;
    if (!c->condition.end || !c->yes.end || !c->no.end || c->nested ||
        c->no.end - start > LONGEST_CHOICE || memchr(r->s->text + start, '\n', c->no.end - start))
        return "condition ? value : value";
    Text text = text_new(r->session->arena);
    const Part parts[] = {c->condition, c->yes, c->no};
    for (int i = 0; i < 3; i++)
        text_format(&text, "%s%.*s",
                    i == 0   ? ""
                    : i == 1 ? " ? "
                             : " : ",
                    (int)(parts[i].end - parts[i].start), r->s->text + parts[i].start);
    return text.at;
}

bool formula_read_if(FormulaReader *r)
{
    if (!is_called(r, &r->token, "if"))
        return false;
    const IfParts c = find_parts(r);
    /* `if(a, b, c)` is reported as an unknown function */
    if (c.bracketed && !c.yes.end && !c.no.end)
        return false;
    r->faults++;
    diag_add(r->session, formula_token_span(r), DIAG_formula_if, choice_text(r, &c));
    formula_push_fault(r);
    r->token = c.behind;
    return true;
}

static bool is_comment(const FormulaReader *r)
{
    const uint32_t size = formula_token_size(r->token);
    return (size == 2 && formula_begins(r->s, r->token.start, "//")) ||
           (size == 1 && formula_begins(r->s, r->token.start, "#"));
}

void formula_pass_other(FormulaReader *r)
{
    uint32_t end = r->token.end;
    for (const bool comment = is_comment(r);
         comment && end < r->s->size && r->s->text[end] != '\n';)
        end++;
    r->token = formula_token(r->s, end);
}

void formula_report_other(FormulaReader *r)
{
    static const char *const meant[][2] = {
        {"×", "; * is the product"},
        {"·", "; * is the product"},
        {"÷", "; / is the quotient"},
        {"−", "; - is the minus sign"},
        {"π", "; write pi"},
        {"$", "; names have no prefix"},
        {"**", "; write a power as a ^ b"},
        {"#", "; formulas have no comments; YAML has them outside strings"},
        {"\"", "; this quote is not closed"},
        {"'", "; this quote is not closed"},
        {"//", "; write a quotient as a / b, an integer quotient as floor(a / b); formulas have no "
               "comments"}};
    const char *hint = "";
    for (size_t i = 0; i < sizeof meant / sizeof *meant; i++)
        if (strlen(meant[i][0]) == formula_token_size(r->token) &&
            !memcmp(meant[i][0], r->s->text + r->token.start, formula_token_size(r->token)))
            hint = meant[i][1];
    if (r->token.kind == TOKEN_text)
        hint = "; only attribute() accepts strings";
    if (formula_is_large(r))
        hint = "; a float holds at most 3.4e38";
    r->faults++;
    diag_add(r->session, formula_token_span(r), DIAG_formula_other,
             formula_token_text(r->s, r->token), hint);
}

/* -- Letters after numbers, decimal commas, `return` */

static bool is_suffix_of_c(const char *letters)
{
    static const char *const suffixes[] = {"f", "F", "h", "H", "d", "D", "l", "L", "lf", "LF"};
    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++)
        if (!strcmp(suffixes[i], letters))
            return true;
    return false;
}

/* Returns the number that ends directly before the token; NULL: none. */
static const FormulaStep *number_before(const FormulaReader *r)
{
    const FormulaStep *step =
        r->operand_count ? &r->f->steps[r->operands[r->operand_count - 1]] : NULL;
    return step && step->kind == FORMULA_number && step->end > step->start &&
                   step->end == r->token.start
               ? step
               : NULL;
}

/* Returns advice for "2u", "45deg", "0.5f", "0x1F". */
static const char *without_suffix(const FormulaReader *r, const FormulaStep *number,
                                  const char *letters)
{
    const int digits = (int)(number->end - number->start);
    const char *written = r->s->text + number->start;
    const bool known = quantity_named(letters, (uint32_t)strlen(letters)) != QUANTITY_none ||
                       names_find(&r->locals, letters) >= 0;
    Text text = text_new(r->session->arena);
    if (!strncmp(letters, "deg", 3))
        text_format(&text, "angles are in radians, write %.*s * pi / 180", digits, written);
    else if (number->number == 0 && *letters == 'x' && letters[1])
        text_put(&text, "numbers are decimal");
    else if (known && !is_suffix_of_c(letters))
        text_format(&text, "write a product as %.*s * %s", digits, written, letters);
    else
        text_format(&text, "numbers have no suffix, write %.*s", digits, written);
    return text.at;
}

bool formula_read_suffix(FormulaReader *r)
{
    const FormulaStep *number = number_before(r);
    const bool point = formula_is(r, ".");
    const Token letters = point ? formula_token(r->s, r->token.end) : r->token;
    const Token behind = formula_token(r->s, letters.end);
    if (!number || letters.kind != TOKEN_name || formula_token_is(&behind, "("))
        return false;
    const char *word = formula_word(r, letters);
    if (point && (letters.start != r->token.end || !is_suffix_of_c(word)))
        return false;
    const Token whole = {.kind = TOKEN_name, .start = number->start, .end = letters.end};
    r->faults++;
    diag_add(r->session, formula_span(r, whole.start, whole.end), DIAG_formula_suffix,
             formula_token_text(r->s, whole), without_suffix(r, number, word));
    r->token = behind;
    return true;
}

bool formula_report_decimal(FormulaReader *r)
{
    const char *text = r->s->text, *comma = text + r->token.start;
    uint32_t start = r->token.start;
    while (start > 0 && text_is_digit(text[start - 1]))
        start--;
    const Token behind = formula_token(r->s, r->token.end);
    const bool fraction = start > 0 && text[start - 1] == '.';
    if (start == r->token.start || fraction || behind.kind != TOKEN_number ||
        behind.start != r->token.end || !text_is_digit(text[behind.start]))
        return false;
    Text number = text_new(r->session->arena);
    text_format(&number, "%.*s.%.*s", (int)(comma - text - start), text + start,
                (int)formula_token_size(behind), text + behind.start);
    r->faults++;
    diag_add(r->session, formula_span(r, start, behind.end), DIAG_decimal_comma, number.at, "");
    formula_next(r);
    return true;
}

void formula_pass_return(FormulaReader *r)
{
    const Token behind = formula_token(r->s, r->token.end);
    if (!is_called(r, &r->token, "return") ||
        (!begins_value(&behind) && !formula_token_is(&behind, "[")))
        return;
    r->faults++;
    diag_add(r->session, formula_token_span(r), DIAG_formula_return);
    formula_next(r);
}
