/* Angular error of unit normals after a round trip through each encoding. */
#include "error.h"
#include "matbench.h"
#include "tests/value/normals.h"
#include <math.h>

enum { DIRECTIONS = 2000000, QUICK_DIRECTIONS = 100000 };

void error_normals(ErrorBench *bench)
{
    double worst_mean = 0, worst_maximum = 0;
    int count = bench->quick ? QUICK_DIRECTIONS : DIRECTIONS;
    FILE *out = bench->part[SECTION_PART_normals];
    fprintf(out, "%d random directions, degrees.\n\n", count);
    fputs("| encoding | mean | rms | max | mean of numerics.md | max of numerics.md |\n"
          "| --- | --- | --- | --- | --- | --- |\n",
          out);
    for (int i = 0; i < normal_rows; i++) {
        bench_show(normal_table[i].name);
        NormalAngles a = normals_measure(&normal_table[i], count);
        fprintf(out, "| %s | %.4g | %.4g | %.4g | %.4g | %.4g |\n", normal_table[i].name, a.mean,
                a.rms, a.maximum, normal_table[i].mean, normal_table[i].maximum);
        const ErrorSubject of = {"normal", normal_table[i].name, ""};
        error_figure(bench, of, "mean_degrees", a.mean);
        error_figure(bench, of, "rms_degrees", a.rms);
        error_figure(bench, of, "max_degrees", a.maximum);
        worst_mean = fmax(worst_mean, fmax(normals_off(a.mean, normal_table[i].mean),
                                           normals_off(a.rms, normal_table[i].rms)));
        if (!normals_are_singular(&normal_table[i]))
            worst_maximum = fmax(worst_maximum, normals_off(a.maximum, normal_table[i].maximum));
    }
    error_target(bench, "table of normal encodings, mean and rms", worst_mean <= 0.01,
                 "within 1 %%|%.2f %% at most", 100 * worst_mean);
    error_target(bench, "table of normal encodings, greatest angle (where it is not chance)",
                 worst_maximum <= 0.01, "within 1 %%|%.2f %% at most", 100 * worst_maximum);
}
