/* Choices of a job as text. choice.c also has choice_job (pipeline.h). */
#ifndef MATC_CHOICE_H
#define MATC_CHOICE_H
#include "compiler/base/session.h"
#include "compiler/base/bytes.h"
#include "compiler/base/suggest.h"
#include "compiler/ir/job.h"
#include "compiler/matc.h"
#include "compiler/base/text.h"

/* The row of the options' target: the default, where they name none; NULL where there is none of
 * that name. */
const TargetRow *choice_target(const MatcOptions *options);
/* The values that an option has by name ("aa": auto, none, ...); false: there is no such option. */
bool choice_values(const char *option, NameChoice *values);
/* Value that an option was given; NULL: none. */
const char *choice_value(const MatcOptions *options, const char *option);
/* As matc_options_set, but any value: what is told apart later, such as "gbuffer,shadow" and the
 * path of a layout. */
bool choice_set(MatcOptions *options, const char *name, const char *value);
/* "aa: there is no 'x', but auto, none, ..." of the first option whose value does not exist, in the
 * arena; NULL: there is none. */
const char *choice_fault(Arena *arena, const MatcOptions *options);
/* All that decides what a program is, as bytes. */
void choice_store_options(Bytes *to, const MatcOptions *options);
/* The options of a caller that may know fewer members, or more: what it does not know has its
 * default. */
MatcOptions choice_whole_options(const MatcOptions *given);
/* Whether matc_options_init, or that of a library with the same number, made the options. */
bool choice_is_set(const MatcOptions *options);
/* Reports options that matc_options_init did not set. False: nothing is to be read or compiled by
 * them. */
bool choice_check(Session *session);
/* A line an axis: its choice and what settled it. For --stats. */
void choice_explain(Text *out, const MatcOptions *options, const Job *job);
#endif
