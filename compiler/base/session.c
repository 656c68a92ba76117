/* Session state: files and statistics. */
#include "compiler/base/session.h"
#include "compiler/base/root.h"
#include <string.h>
#include <time.h>

Session session_open(const MatcOptions *options, Arena *arena)
{
    return (Session){
        .options = options, .arena = arena, .optimize = options->optimize, .check = options->check};
}

const char *session_warnings(const Session *session)
{
    const MatcOptions *options = session->options;
    if (!options)
        return NULL;
    return options->warnings || !*options->warning_text ? options->warnings : options->warning_text;
}

double session_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void session_stage_done(Session *session, const char *name, int nodes, int cost)
{
    if (!session->measure)
        return;
    double now = session_now();
    StageStats stats = {name, now - session->stage_start, nodes, cost};
    ARENA_PUSH(session->arena, session->stats, session->stat_count, session->stat_capacity, stats);
    /* restarts the clock, which excludes the time that statistics take */
    session->stage_start = session_now();
}

char *session_read_file(Session *session, const char *path, size_t *size, const char **why)
{
    if (session->options->read_file)
        return session->options->read_file(session->options->user, path, size, why);
    return root_read(session->options->root, path, size, why);
}

void session_depend_on(Session *session, const char *path)
{
    names_add(session->arena, &session->depends, path);
}

const char *session_path_beside(Session *session, const char *from, const char *path)
{
    const char *slash = strrchr(from, '/');
    Text joined = text_new(session->arena);
    if (path[0] != '/' && slash)
        text_add(&joined, from, (size_t)(slash - from) + 1);
    text_put(&joined, path);
    root_normalize(joined.at);
    if (joined.at[0] != '<')
        return joined.at;
    /* Standard input is called <stdin>, so a file of that name gets the prefix "./". */
    Text here = text_new(session->arena);
    text_format(&here, "./%s", joined.at);
    return here.at;
}
