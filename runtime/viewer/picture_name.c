/* Derives file names of pictures from documents and the command line. */
#include "runtime/viewer/picture_name.h"
#include "compiler/base/text.h"
#include <stdio.h>
#include <string.h>

void picture_name_of(const char *input, const char *material, char name[PICTURE_NAME_CAPACITY])
{
    if (!strcmp(input, "-"))
        input = "stdin";
    const char *slash = strrchr(input, '/'), *stem = slash ? slash + 1 : input,
               *dot = strrchr(stem, '.');
    int size = dot && dot != stem ? (int)(dot - stem) : (int)strlen(stem);
    snprintf(name, PICTURE_NAME_CAPACITY, "%.*s%s%s", size, stem, material ? "." : "",
             material ? material : "");
}

const char *picture_name_claim(PictureOwners *owners, const char *path, const char *input)
{
    if (!strcmp(path, "-"))
        return NULL;
    const int found = names_find(&owners->paths, path);
    if (found >= 0 && !strcmp(owners->inputs[found], input))
        return NULL;
    if (found >= 0) {
        Text why = text_new(&owners->arena);
        text_format(&why,
                    "this image was rendered from %s; use -d with another folder to keep both",
                    owners->inputs[found]);
        return why.at;
    }
    names_add(&owners->arena, &owners->paths, arena_string(&owners->arena, path, strlen(path)));
    ARENA_PUSH(&owners->arena, owners->inputs, owners->input_count, owners->input_capacity, input);
    return NULL;
}

void picture_name_path(const Command *command, const char *name, char path[PICTURE_NAME_PATH])
{
    if (command->output)
        snprintf(path, PICTURE_NAME_PATH, "%s", command->output);
    else
        snprintf(path, PICTURE_NAME_PATH, "%s%s%s.%s", command->folder ? command->folder : "",
                 command->folder ? "/" : "", name,
                 command->format == PICTURE_FORMAT_exr ? "exr" : "png");
}

const char *picture_name_frame(const Command *command, const char *input, int frame,
                               char path[PICTURE_NAME_PATH])
{
    char name[PICTURE_NAME_CAPACITY], pattern[PICTURE_NAME_PATH];
    const bool numbered =
        command->frames.given && (command->frames.first < command->frames.last ||
                                  !command->output || strchr(command->output, '%'));
    picture_name_of(input, NULL, name);
    if (!numbered)
        return picture_name_path(command, name, path), NULL;
    const size_t size = strlen(name);
    if (!command->output) {
        snprintf(name + size, sizeof name - size, "-%04d", frame);
        return picture_name_path(command, name, path), NULL;
    }
    picture_name_path(command, name, pattern);
    return frames_path(pattern, frame, path, PICTURE_NAME_PATH)
               ? NULL
               : "-o needs a placeholder for the frame number: out-%04d.png";
}
