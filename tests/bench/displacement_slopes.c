/* matbench displacement, the table of slopes: what normals of a curved surface that is displaced are off where those of its base are taken to stay as they are, and where they turn as the base does. */
#include "displacement.h"
#include "matbench.h"
#include "tests/value/curved.h"
#include "tests/value/documents.h"
#include <math.h>
#include <stdio.h>

enum { POINTS = 4000, TEXT = 200, PARTS = 4 };

/* Degrees in the root of the mean square, and at most. */
typedef struct {
    double mean, most;
} Off;

static Off off_truth(Oracle *oracle, const Node *material, CurvedBody body, double scale, bool stays)
{
    Off off = {0, 0};
    for (int i = 0; i < POINTS; i++) {
        Surface surface;
        SlotValues values;
        double want[3];
        curved_surface(body, fmod(i * 0.61803398874989485, 1), (i + 0.5) / POINTS, &surface);
        curved_normal(body, scale, &surface.root[channel_id(GROUP_P, 0)], false, want);
        for (int lane = 0; lane < 3 && stays; lane++)
            surface.normal_u[lane] = surface.normal_v[lane] = 0;
        oracle_material(oracle, material, &surface, &values);
        const double angle = curved_angle(values.lane[SLOT_normal], want);
        off.mean += angle * angle / POINTS;
        off.most = fmax(off.most, angle);
    }
    off.mean = sqrt(off.mean);
    return off;
}

static bool print_row(CurvedBody body, double part)
{
    static const char *const names[CURVED_COUNT] = {"ball", "torus"};
    const double scale = part * curved_radius[body];
    char text[TEXT];
    Document d;
    snprintf(text, sizeof text, "material: Phong\ndisplacement: " CURVED_HEIGHT "\ndisplacementScale: %.17g\n", scale);
    const bool fine = document_open_text(&d, text);
    if (fine) {
        Oracle *oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        const Off stay = off_truth(oracle, d.graph->materials[0].node, body, scale, true),
                  turn = off_truth(oracle, d.graph->materials[0].node, body, scale, false);
        printf("%-8s %8.2f %12.3f %8.2f %14.1e %10.1e\n", names[body], part, stay.mean, stay.most, turn.mean, turn.most);
        oracle_close(oracle);
    }
    document_close(&d);
    return fine;
}

bool displacement_slopes(void)
{
    bool fine = true;
    printf("\nnormals of curved bodies that rise and fall: degrees off the closed form, in the mean square and at most\n%-8s %8s %21s %25s\n", "body", "h / r",
           "the base's stay", "they turn");
    for (CurvedBody body = 0; body < CURVED_COUNT; body++)
        for (int i = 0; fine && i < PARTS; i++)
            fine = print_row(body, 0.05 * (1 << i));
    return fine;
}
