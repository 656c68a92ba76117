/* Full-screen pass: one triangle that contains the square from (-1, -1) to (1, 1) of clip space,
 * so that no edge crosses the picture. */
#include "runtime/gl/screen.h"
#include <string.h>

const char screen_text_old[] =
    "attribute vec4 position;\nvoid main() { gl_Position = position; }\n";
const char screen_text[] = "in vec4 position;\nvoid main() { gl_Position = position; }\n";

bool screen_make(GlContext *gl, Screen *made)
{
    static const float corners[] = {-1, -1, 3, -1, -1, 3};
    gl->GenVertexArrays(1, &made->array);
    gl->GenBuffers(1, &made->buffer);
    gl->BindVertexArray(made->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, made->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL); /* two components: z is 0, w is 1 */
    gl->EnableVertexAttribArray(0);
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    if (gl_check(gl, "making a screen"))
        return true;
    screen_delete(gl, made);
    return false;
}

void screen_draw(const GlContext *gl, const Screen *screen)
{
    gl->BindVertexArray(screen->array);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindVertexArray(0);
}

void screen_delete(const GlContext *gl, Screen *screen)
{
    gl->DeleteVertexArrays(1, &screen->array); /* GL ignores the name 0 */
    gl->DeleteBuffers(1, &screen->buffer);
    memset(screen, 0, sizeof *screen);
}
