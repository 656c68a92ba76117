/* Warnings about parts of a physically based material that no G-buffer holds, or not as they are:
 * UNSTORED and PARTED of materials.def. */
#include "compiler/hints/doubt.h"

static bool is_lost(const Node *node, int i)
{
    return param_is_unstored(kind_table[node->kind].first + i) && !value_is_zero(&node->params[i]);
}

/* What becomes of what is given of a body's inside, where there is one; NULL: it is kept. */
static const char *parted(const Node *node, int i)
{
    int weight;
    const char *what = param_parted(kind_table[node->kind].first + i, &weight);
    const bool there = what && node->params[i].given && !value_is_zero(&node->params[i]) &&
                       !value_is_zero(node_param(node, weight));
    return there && value_is_zero(node_param(node, P_Principled_thinWalled)) ? what : NULL;
}

void doubt_lost(Session *session, const Node *material)
{
    for (int i = 0; i < kind_table[material->kind].count; i++) {
        const char *what = parted(material, i);
        const Span span = material->params[i].span;
        if (is_lost(material, i))
            diag_add(session, span, DIAG_unstored, node_written_param(material, i),
                     node_written_name(material));
        else if (what)
            diag_add(session, span, DIAG_parted, node_written_param(material, i),
                     node_written_name(material), what);
    }
}
