#include "tests/frame/frame_moved.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

typedef struct {
    yaml_document_t document;
    const FrameMove *move;
} Mover;

static void end(const char *why)
{
    fprintf(stderr, "moving a scene: %s\n", why);
    abort();
}

static int scalar(Mover *m, const char *text)
{
    return yaml_document_add_scalar(&m->document, NULL, (const yaml_char_t *)text, -1,
                                    YAML_PLAIN_SCALAR_STYLE);
}

static int vector(Mover *m, const double v[3])
{
    const int list = yaml_document_add_sequence(&m->document, NULL, YAML_FLOW_SEQUENCE_STYLE);
    for (int i = 0; i < 3; i++) {
        char text[40];
        snprintf(text, sizeof text, "%.17g", v[i]);
        yaml_document_append_sequence_item(&m->document, list, scalar(m, text));
    }
    return list;
}

/* The pair with a key; NULL if the mapping lacks it. */
static yaml_node_pair_t *pair_of(Mover *m, int mapping, const char *key)
{
    yaml_node_t *node = yaml_document_get_node(&m->document, mapping);
    if (node->type != YAML_MAPPING_NODE)
        return NULL;
    for (yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         pair < node->data.mapping.pairs.top; pair++)
        if (!strcmp(
                (const char *)yaml_document_get_node(&m->document, pair->key)->data.scalar.value,
                key))
            return pair;
    return NULL;
}

static int value_of(Mover *m, int mapping, const char *key)
{
    const yaml_node_pair_t *pair = mapping ? pair_of(m, mapping, key) : NULL;
    return pair ? pair->value : 0;
}

static void put(Mover *m, int mapping, const char *key, int value)
{
    yaml_node_pair_t *pair = pair_of(m, mapping, key);
    if (pair)
        pair->value = value;
    else
        yaml_document_append_mapping_pair(&m->document, mapping, scalar(m, key), value);
}

static const char *text_of(Mover *m, int node)
{
    const yaml_node_t *at = node ? yaml_document_get_node(&m->document, node) : NULL;
    return at && at->type == YAML_SCALAR_NODE ? (const char *)at->data.scalar.value : "";
}

/* Reads a vector of the mapping, or leaves the default. */
static void read_vector(Mover *m, int mapping, const char *key, double v[3])
{
    const yaml_node_t *node = yaml_document_get_node(&m->document, value_of(m, mapping, key));
    for (int i = 0; node && i < 3; i++)
        v[i] =
            strtod(node->type == YAML_SEQUENCE_NODE ? text_of(m, node->data.sequence.items.start[i])
                                                    : (const char *)node->data.scalar.value,
                   NULL);
}

static void turn(const FrameMove *move, double v[3])
{
    for (int axis = 0; axis < 3; axis++) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        const double c = cos(move->rotation[axis]), s = sin(move->rotation[axis]), x = v[a],
                     y = v[b];
        v[a] = c * x - s * y;
        v[b] = s * x + c * y;
    }
}

static void move_vector(Mover *m, int mapping, const char *key, const double init[3], bool point)
{
    double v[3] = {init[0], init[1], init[2]};
    read_vector(m, mapping, key, v);
    turn(m->move, v);
    for (int i = 0; point && i < 3; i++)
        v[i] += m->move->translation[i];
    put(m, mapping, key, vector(m, v));
}

static void move_camera(Mover *m, int root)
{
    static const double position[3] = {0, -5, 2}, target[3], up[3] = {0, 0, 1};
    int camera = value_of(m, root, "camera");
    if (!camera) {
        camera = yaml_document_add_mapping(&m->document, NULL, YAML_BLOCK_MAPPING_STYLE);
        put(m, camera, "camera", scalar(m, "Perspective"));
        put(m, root, "camera", camera);
    }
    move_vector(m, camera, "position", position, true);
    move_vector(m, camera, "target", target, true);
    move_vector(m, camera, "up", up, false);
    const yaml_node_t *keys =
        yaml_document_get_node(&m->document, value_of(m, value_of(m, root, "motion"), "keys"));
    for (int i = 0; keys && &keys->data.sequence.items.start[i] < keys->data.sequence.items.top;
         i++) {
        move_vector(m, keys->data.sequence.items.start[i], "position", position, true);
        move_vector(m, keys->data.sequence.items.start[i], "target", target, true);
        keys =
            yaml_document_get_node(&m->document, value_of(m, value_of(m, root, "motion"), "keys"));
    }
}

static void move_light(Mover *m, int light)
{
    static const double zero[3], above[3] = {0, 0, 1}, down[3] = {0, 0, -1}, u[3] = {0, 1, 0},
                                 v[3] = {1, 0, 0};
    const char *kind = text_of(m, value_of(m, light, "light"));
    const bool area = !strcmp(kind, "Area"), spot = !strcmp(kind, "Spot"),
               far = !strcmp(kind, "Directional");
    if (area || spot || !strcmp(kind, "Point"))
        move_vector(m, light, "position", area ? above : zero, true);
    if (spot || far)
        move_vector(m, light, "direction", down, false);
    if (area) {
        move_vector(m, light, "u", u, false);
        move_vector(m, light, "v", v, false);
    }
}

static int transform_of(Mover *m)
{
    const int transform = yaml_document_add_mapping(&m->document, NULL, YAML_FLOW_MAPPING_STYLE);
    put(m, transform, "rotation", vector(m, m->move->rotation));
    put(m, transform, "translation", vector(m, m->move->translation));
    return transform;
}

static void wrap_objects(Mover *m, int root, int objects)
{
    const int group = yaml_document_add_mapping(&m->document, NULL, YAML_BLOCK_MAPPING_STYLE);
    const int list = yaml_document_add_sequence(&m->document, NULL, YAML_BLOCK_SEQUENCE_STYLE);
    put(m, group, "object", scalar(m, "Group"));
    put(m, group, "transform", transform_of(m));
    put(m, group, "objects", objects);
    yaml_document_append_sequence_item(&m->document, list, group);
    put(m, root, "objects", list);
}

/* Adds to the object's own translation. */
static void move_object(Mover *m, int object)
{
    static const double zero[3];
    int transform = value_of(m, object, "transform");
    if (!transform) {
        transform = yaml_document_add_mapping(&m->document, NULL, YAML_FLOW_MAPPING_STYLE);
        put(m, object, "transform", transform);
    }
    if (yaml_document_get_node(&m->document, transform)->type != YAML_MAPPING_NODE)
        end("a matrix");
    move_vector(m, transform, "translation", zero, true);
}

static int item_of(Mover *m, int list, int i)
{
    const yaml_node_t *node = yaml_document_get_node(&m->document, list);
    const yaml_node_item_t *at = node->data.sequence.items.start + i;
    return at < node->data.sequence.items.top ? *at : 0;
}

static void move_all(Mover *m)
{
    const int root = 1, objects = value_of(m, root, "objects"),
              lights = value_of(m, root, "lights");
    move_camera(m, root);
    for (int i = 0; lights && item_of(m, lights, i); i++)
        move_light(m, item_of(m, lights, i));
    for (int i = 0; m->move->apart && objects && item_of(m, objects, i); i++)
        move_object(m, item_of(m, objects, i));
    if (!m->move->apart && objects)
        wrap_objects(m, root, objects);
}

static int append(void *user, unsigned char *bytes, size_t size)
{
    return fwrite(bytes, 1, size, user) == size;
}

char *frame_moved(const char *text, const FrameMove *move)
{
    Mover m = {.move = move};
    yaml_parser_t parser;
    yaml_emitter_t emitter;
    char *made = NULL;
    size_t size;
    FILE *out = open_memstream(&made, &size);
    if (!out || !yaml_parser_initialize(&parser) || !yaml_emitter_initialize(&emitter))
        end("out of memory");
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, strlen(text));
    if (!yaml_parser_load(&parser, &m.document))
        end(parser.problem);
    move_all(&m);
    yaml_emitter_set_output(&emitter, append, out);
    yaml_emitter_set_unicode(&emitter, 1);
    yaml_emitter_set_width(&emitter, -1);
    if (!yaml_emitter_open(&emitter) || !yaml_emitter_dump(&emitter, &m.document) ||
        !yaml_emitter_close(&emitter))
        end(emitter.problem);
    yaml_emitter_delete(&emitter);
    yaml_parser_delete(&parser);
    fclose(out);
    return made;
}
