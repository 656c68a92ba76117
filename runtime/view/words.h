/* What is wrong with a word of matview's command line: the word, what may stand there, what was perhaps meant. */
#ifndef MATC_VIEW_WORDS_H
#define MATC_VIEW_WORDS_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    char *text; /* room for what is wrong */
    size_t size;
    const char *help; /* names the options, each with its -- */
} WordsRoom;

/* NULL: the value may stand behind the option, or the option takes other things than words. */
const char *words_fault(WordsRoom room, const char *option, const char *value);
/* "--watch takes no value" of an option that there is, and what is wrong with it; "there is no option '--shap'; did you mean
 * '--shape'?" of another. The option ends at a '='. */
const char *words_option(WordsRoom room, const char *option, const char *wrong);
/* "--size wants a number from 1, not 'x'" */
const char *words_number(WordsRoom room, const char *wants, const char *value);
#endif
