# Adds the example operation that the head of grammar/ops.def explains: inserts the example's rows,
# without the comment's stars, before the table's end.
/To add an operation/ { shown = 1 }
shown && /^ \* +[A-Z_]+\(/ { row = $0; sub(/^ \* +/, "", row); example = example row "\n" }
/^#undef OP$/ { printf "%s", example }
{ print }
