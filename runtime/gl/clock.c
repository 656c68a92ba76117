/* GPU timing by timer queries. */
#include "runtime/gl/clock.h"

bool gl_clock_is(const GlContext *gl) { return gl->hardware && gl->GetQueryObjectui64v; }

GLuint gl_clock_start(const GlContext *gl)
{
    GLuint query = 0;
    gl->GenQueries(1, &query);
    gl->BeginQuery(GL_TIME_ELAPSED, query);
    return query;
}

double gl_clock_stop(const GlContext *gl, GLuint query)
{
    GLuint64 nanoseconds = 0;
    gl->EndQuery(GL_TIME_ELAPSED);
    /* blocks until the result is available */
    gl->GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    gl->DeleteQueries(1, &query);
    return (double)nanoseconds * 1e-9;
}
