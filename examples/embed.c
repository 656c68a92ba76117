/* matc in a program of your own: a material from a string to GLSL, with its uniforms. Build:
 *     cc embed.c $(pkg-config --cflags --libs matc)
 * or, in CMake, find_package(matc) and target_link_libraries(embed PRIVATE matc::matc). */
#include <matc.h>
#include <stdio.h>
#include <string.h>

static const char material[] = "material: Phong\n"
                               "diffuse:\n"
                               "  map: Checker\n"
                               "  color1: { param: tint, default: [0.9, 0.4, 0.1] }\n"
                               "  color2: 0.05\n"
                               "  input: { map: UVTransform, scaleU: 8, scaleV: 4 }\n";

static void print_program(const MatcProgram *program)
{
    puts(matc_output(program, MATC_FRAGMENT, NULL));
    for (int i = 0; i < matc_uniform_count(program); i++) {
        const MatcUniform *uniform = matc_uniform(program, i);
        printf("// uniform %s: %d components, default %g", uniform->name, uniform->components,
               uniform->initial[0]);
        for (int component = 1; component < uniform->components; component++)
            printf(", %g", uniform->initial[component]);
        putchar('\n');
    }
}

int main(void)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("embedded.yaml", material, strlen(material), &options);
    int status = 1;
    if (matc_material_count(document)) {
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        if (matc_ok(program)) {
            print_program(program);
            status = 0;
        }
        fputs(matc_program_diagnostics(program, MATC_TEXT), stderr);
        matc_program_free(program);
    }
    fputs(matc_diagnostics(document, MATC_TEXT), stderr);
    matc_document_free(document);
    return status;
}
