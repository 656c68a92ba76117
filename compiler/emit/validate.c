/* glslang's C interface. It is initialised once for the process, by whichever thread comes first, and never torn down: its
 * built-in symbol tables are most of the cost of a first compilation. */
#include "compiler/emit/validate.h"
#include "compiler/base/bytes.h"
#include "compiler/emit/linked.h"
#include <glslang/Include/glslang_c_interface.h>
#include <pthread.h>
#include <string.h>

/* Of Debian's libglslang-default-resource-limits, which has no C header of its own. */
extern const glslang_resource_t *glslang_default_resource(void);

static pthread_once_t initialised = PTHREAD_ONCE_INIT;
static void initialise(void) { glslang_initialize_process(); }

typedef struct {
    glslang_shader_t *shaders[2];
    int shader_count;
    glslang_program_t *program;
} Session;

static glslang_input_t input_for(Target target, glslang_stage_t stage, const char *code)
{
    bool vulkan = target == TARGET_spirv;
    glslang_input_t input = {.language = GLSLANG_SOURCE_GLSL,
                             .stage = stage,
                             .client = vulkan ? GLSLANG_CLIENT_VULKAN : GLSLANG_CLIENT_NONE,
                             .client_version = vulkan ? GLSLANG_TARGET_VULKAN_1_0 : GLSLANG_TARGET_OPENGL_450,
                             .target_language = vulkan ? GLSLANG_TARGET_SPV : GLSLANG_TARGET_NONE,
                             .target_language_version =
                                 vulkan ? GLSLANG_TARGET_SPV_1_0 : (glslang_target_language_version_t)0,
                             .code = code,
                             .default_version = target_table[target].number,
                             .default_profile = GLSLANG_NO_PROFILE,
                             .messages = GLSLANG_MSG_DEFAULT_BIT,
                             .resource = glslang_default_resource()};
    if (vulkan)
        input.messages = (glslang_messages_t)(GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT);
    return input;
}

static const char *keep(Compile *c, const char *log)
{
    return arena_string(c->arena, log ? log : "", log ? strlen(log) : 0);
}

/* The text without what follows `//`: glslang reads every letter, and the lines keep their numbers. */
static const char *without_comments(Compile *c, const char *code)
{
    char *bare = arena_alloc(c->arena, strlen(code) + 1), *to = bare;
    for (const char *comment; (comment = strstr(code, "//")); code = comment + strcspn(comment, "\n")) {
        memcpy(to, code, (size_t)(comment - code));
        to += comment - code;
    }
    strcpy(to, code);
    return bare;
}

static bool parse(Compile *c, Session *session, Target target, glslang_stage_t stage, const char *code,
                  const char **log)
{
    const glslang_input_t input = input_for(target, stage, without_comments(c, code));
    glslang_shader_t *shader = glslang_shader_create(&input);
    if (!shader)
        return false;
    session->shaders[session->shader_count++] = shader;
    if (glslang_shader_preprocess(shader, &input) && glslang_shader_parse(shader, &input)) {
        glslang_program_add_shader(session->program, shader);
        return true;
    }
    *log = keep(c, glslang_shader_get_info_log(shader));
    return false;
}

static bool link_session(Compile *c, Session *session, Target target, const char *vertex, const char *fragment,
                         const char **log)
{
    *log = "glslang cannot be started";
    pthread_once(&initialised, initialise);
    session->program = glslang_program_create();
    if (!session->program || (vertex && !parse(c, session, target, GLSLANG_STAGE_VERTEX, vertex, log)) ||
        (fragment && !parse(c, session, target, GLSLANG_STAGE_FRAGMENT, fragment, log)))
        return false;
    int messages = (int)input_for(target, GLSLANG_STAGE_FRAGMENT, "").messages;
    if (glslang_program_link(session->program, messages))
        return true;
    *log = keep(c, glslang_program_get_info_log(session->program));
    return false;
}

static void close_session(Session *session)
{
    if (session->program)
        glslang_program_delete(session->program);
    for (int i = 0; i < session->shader_count; i++)
        glslang_shader_delete(session->shaders[i]);
}

/* All that a fragment program and its vertex program can disagree about: the one's declarations, and the other. */
static Key interface_key(Target target, const char *vertex, const char *fragment, size_t declarations)
{
    Bytes bytes = {0};
    bytes_number(&bytes, (uint32_t)target);
    bytes_text(&bytes, vertex);
    bytes_block(&bytes, fragment, declarations);
    Key key = key_of_bytes(bytes.at, bytes.size);
    bytes_free(&bytes);
    return key;
}

bool validate(Compile *c, Target target, const char *vertex, const char *fragment, size_t declarations,
              const char **log)
{
    Session session = {0};
    MatcLinked *linked = c->options ? c->options->linked : NULL;
    Key key = linked ? interface_key(target, vertex, fragment, declarations) : (Key){0, 0};
    bool known = linked_before(linked, key),
         fine = link_session(c, &session, target, known ? NULL : vertex, fragment, log);
    if (fine && !known)
        linked_add(linked, key);
    close_session(&session);
    return fine;
}

const char *make_spirv(Compile *c, const char *fragment, size_t *size, const char **log)
{
    Session session = {0};
    const char *words = NULL;
    if (link_session(c, &session, TARGET_spirv, NULL, fragment, log)) {
        glslang_spv_options_t options = {.disable_optimizer = true, .validate = false};
        glslang_program_SPIRV_generate_with_options(session.program, GLSLANG_STAGE_FRAGMENT, &options);
        *size = glslang_program_SPIRV_get_size(session.program) * sizeof(unsigned);
        words = arena_string(c->arena, (const char *)glslang_program_SPIRV_get_ptr(session.program), *size);
    }
    close_session(&session);
    return words;
}
