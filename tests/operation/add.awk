# Adds the operation that the head of grammar/ops.def shows how to add, as whoever follows it would: the rows of the example, without
# their comment's stars, before the table's end.
/To add an operation/ { shown = 1 }
shown && /^ \* +[A-Z_]+\(/ { row = $0; sub(/^ \* +/, "", row); example = example row "\n" }
/^#undef OP$/ { printf "%s", example }
{ print }
