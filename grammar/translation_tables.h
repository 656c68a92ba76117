/* translations.def as const arrays: the translation of other models' materials to Principled. */
#ifndef MATC_TRANSLATION_TABLES_H
#define MATC_TRANSLATION_TABLES_H
#include "tables.h"

typedef struct {
    Kind from;
    int to;              /* parameter of Principled, in param_table */
    const char *formula; /* formula over the material's parameters; NULL: a NormalMap */
    int map, scale;      /* map and scale of a NormalMap: parameters of the material */
    const char *where;   /* applies only if this formula may be nonzero; NULL: always */
} TranslationRow;
extern const TranslationRow translation_table[];
extern const int translation_count;

typedef struct {
    int param;           /* index in param_table */
    const char *formula; /* value 0: the translation loses nothing */
    const char *what;
} LossRow;
extern const LossRow loss_table[];
extern const int loss_count;
#endif
