/* Options of a job by name, and as text. choice.c also has choice_job (pipeline.h). */
#ifndef MATC_CHOICE_H
#define MATC_CHOICE_H
#include "compiler/base/session.h"
#include "compiler/base/bytes.h"
#include "compiler/base/suggest.h"
#include "compiler/ir/job.h"
#include "compiler/matc.h"
#include "compiler/base/text.h"

/* Returns the row of the options' target, or of the default target; NULL: the target's name is
 * unknown. */
const TargetRow *choice_target(const MatcOptions *options);
/* Returns the values of an option ("aa": auto, none, ...). Returns false for an unknown option. */
bool choice_values(const char *option, NameChoice *values);
/* Returns the value of an option; NULL: not given. */
const char *choice_value(const MatcOptions *options, const char *option);
/* Sets an option like matc_options_set, but without checking the value: values such as
 * "gbuffer,shadow" and the path of a layout are interpreted later. */
bool choice_set(MatcOptions *options, const char *name, const char *value);
/* Returns "aa: there is no 'x', but auto, none, ..." for the first option with an unknown value,
 * in the arena; NULL: all are valid. */
const char *choice_fault(Arena *arena, const MatcOptions *options);
/* Appends everything that determines a program, as bytes. */
void choice_store_options(Bytes *to, const MatcOptions *options);
/* Returns the options of a caller that may have been compiled with fewer or more members:
 * missing members get their defaults. */
MatcOptions choice_whole_options(const MatcOptions *given);
/* Returns true if the options were initialized by matc_options_init of any library version with
 * this number. */
bool choice_is_set(const MatcOptions *options);
/* Reports options that were not initialized by matc_options_init. Returns false if nothing may
 * be read or compiled. */
bool choice_check(Session *session);
/* Writes a line per axis: its choice and the choice's source. For --stats. */
void choice_explain(Text *out, const MatcOptions *options, const Job *job);
#endif
