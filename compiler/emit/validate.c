/* Validates programs by glslang's C interface. glslang is initialized once per process, by the
 * first thread, and never finalized: its built-in symbol tables are the main cost of a first
 * compilation. */
#include "compiler/emit/validate.h"
#include "compiler/base/bytes.h"
#include "compiler/emit/linked.h"
#include <glslang/Include/glslang_c_interface.h>
#include <pthread.h>
#include <string.h>

/* Declared here because Debian's libglslang-default-resource-limits has no C header. */
extern const glslang_resource_t *glslang_default_resource(void);

static pthread_once_t initialised = PTHREAD_ONCE_INIT;
static void initialise(void) { glslang_initialize_process(); }

typedef struct {
    Session *session;
    Target target;
    glslang_shader_t *shaders[4];
    int shader_count;
    glslang_program_t *program;
    const char *log; /* log of the failed shader or program */
} Validation;

static glslang_input_t input_for(Target target, glslang_stage_t stage, const char *code)
{
    bool vulkan = target_table[target].spirv;
    glslang_input_t input = {
        .language = GLSLANG_SOURCE_GLSL,
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
        input.messages =
            (glslang_messages_t)(GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT);
    return input;
}

/* Copies glslang's log, which is freed with its shader or program. */
static bool fail(Validation *v, const char *log)
{
    v->log = arena_string(v->session->arena, log ? log : "", log ? strlen(log) : 0);
    return false;
}

/* Returns the text without // comments, to save parsing time; line numbers are unchanged. */
static const char *without_comments(Session *session, const char *code)
{
    char *bare = arena_alloc(session->arena, strlen(code) + 1), *to = bare;
    for (const char *comment; (comment = strstr(code, "//"));
         code = comment + strcspn(comment, "\n")) {
        memcpy(to, code, (size_t)(comment - code));
        to += comment - code;
    }
    strcpy(to, code);
    return bare;
}

static bool parse(Validation *v, glslang_stage_t stage, const char *code)
{
    const glslang_input_t input = input_for(v->target, stage, without_comments(v->session, code));
    glslang_shader_t *shader = glslang_shader_create(&input);
    if (!shader)
        return false;
    v->shaders[v->shader_count++] = shader;
    if (glslang_shader_preprocess(shader, &input) && glslang_shader_parse(shader, &input)) {
        glslang_program_add_shader(v->program, shader);
        return true;
    }
    return fail(v, glslang_shader_get_info_log(shader));
}

static bool link_shaders(Validation *v, const char *vertex, const char *fragment)
{
    v->log = "glslang cannot be started";
    pthread_once(&initialised, initialise);
    v->program = glslang_program_create();
    if (!v->program || (vertex && !parse(v, GLSLANG_STAGE_VERTEX, vertex)) ||
        (fragment && !parse(v, GLSLANG_STAGE_FRAGMENT, fragment)))
        return false;
    int messages = (int)input_for(v->target, GLSLANG_STAGE_FRAGMENT, "").messages;
    return glslang_program_link(v->program, messages) ||
           fail(v, glslang_program_get_info_log(v->program));
}

static void close_validation(Validation *v)
{
    if (v->program)
        glslang_program_delete(v->program);
    for (int i = 0; i < v->shader_count; i++)
        glslang_shader_delete(v->shaders[i]);
}

/* Key of the interface between a vertex and a fragment program: the vertex program, and the
 * declarations of the fragment program. */
static Key interface_key(Target target, const ProgramTexts *texts)
{
    Bytes bytes = {0};
    bytes_number(&bytes, (uint32_t)target);
    bytes_text(&bytes, texts->vertex);
    bytes_block(&bytes, texts->fragment, texts->declarations);
    Key key = key_of_bytes(bytes.at, bytes.size);
    bytes_free(&bytes);
    return key;
}

bool validate(Session *session, Target target, const ProgramTexts *texts, const char **log)
{
    Validation v = {.session = session, .target = target};
    MatcLinked *linked = session->options ? session->options->linked : NULL;
    Key key = linked ? interface_key(target, texts) : (Key){0, 0};
    bool known = linked_before(linked, key),
         fine = link_shaders(&v, known ? NULL : texts->vertex, texts->fragment);
    if (fine && !known)
        linked_add(linked, key);
    *log = v.log;
    close_validation(&v);
    return fine;
}

static const glslang_stage_t kinds[VALIDATE_STAGES] = {
    GLSLANG_STAGE_VERTEX,   GLSLANG_STAGE_TESSCONTROL, GLSLANG_STAGE_TESSEVALUATION,
    GLSLANG_STAGE_GEOMETRY, GLSLANG_STAGE_FRAGMENT,    GLSLANG_STAGE_COMPUTE};

static bool link_stages(Validation *v, const ValidateStages *stages)
{
    const int messages = (int)input_for(v->target, GLSLANG_STAGE_FRAGMENT, "").messages;
    v->log = "glslang cannot be started";
    pthread_once(&initialised, initialise);
    v->program = glslang_program_create();
    bool fine = v->program != NULL;
    for (int i = 0; i < VALIDATE_STAGES && fine; i++)
        fine = !stages->text[i] || parse(v, kinds[i], stages->text[i]);
    return fine && (glslang_program_link(v->program, messages) ||
                    fail(v, glslang_program_get_info_log(v->program)));
}

bool validate_stages(Session *session, Target target, const ValidateStages *stages,
                     const char **log)
{
    Validation v = {.session = session, .target = target};
    const bool fine = link_stages(&v, stages);
    *log = v.log;
    close_validation(&v);
    return fine;
}

/* Takes the SPIR-V words of the next stage. glslang up to version 12 appends them to those of
 * earlier stages, whose total size is *all. */
static void take_words(Validation *v, int stage, ValidateWords *words, size_t *all)
{
    glslang_spv_options_t options = {.disable_optimizer = true, .validate = false};
    glslang_program_SPIRV_generate_with_options(v->program, kinds[stage], &options);
    const char *at = (const char *)glslang_program_SPIRV_get_ptr(v->program);
    const size_t size = glslang_program_SPIRV_get_size(v->program) * sizeof(unsigned);
    int first = 0;
    while (first < stage && !words->at[first])
        first++;
    const bool behind =
        first < stage && size > *all && !memcmp(at, words->at[first], words->size[first]);
    const size_t from = behind ? *all : 0;
    words->size[stage] = size - from;
    words->at[stage] = arena_string(v->session->arena, at + from, size - from);
    *all = size;
}

bool validate_to_spirv(Session *session, const ValidateStages *stages, ValidateWords *words,
                       const char **log)
{
    Validation v = {.session = session, .target = TARGET_spirv};
    const bool fine = link_stages(&v, stages);
    size_t all = 0;
    *words = (ValidateWords){{NULL}, {0}};
    for (int i = 0; i < VALIDATE_STAGES && fine; i++)
        if (stages->text[i])
            take_words(&v, i, words, &all);
    *log = v.log;
    close_validation(&v);
    return fine;
}
