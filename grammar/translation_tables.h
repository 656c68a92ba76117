/* translations.def as const arrays: how materials of others become Principled ones. */
#ifndef MATC_TRANSLATION_TABLES_H
#define MATC_TRANSLATION_TABLES_H
#include "tables.h"

typedef struct {
    Kind from;
    int to;              /* Principled's parameter, in param_table */
    const char *formula; /* of the material's parameters; NULL: a NormalMap */
    int map, scale;      /* of a NormalMap: the material's parameters */
    const char *where;   /* read only where this formula is not 0, or may be; NULL: always */
} TranslationRow;
extern const TranslationRow translation_table[];
extern const int translation_count;

typedef struct {
    int param;           /* in param_table */
    const char *formula; /* nothing is lost where it is 0 */
    const char *what;
} LossRow;
extern const LossRow loss_table[];
extern const int loss_count;
#endif
