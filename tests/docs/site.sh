#!/bin/sh
# Every link and anchor of the Markdown leads somewhere, and every picture of docs/pictures is shown
# by a page; the same of the built site, which loads nothing from elsewhere: site.sh BUILD_FOLDER.
# Run from the project's root. Status 77: the Markdown was checked, but the site was not built.
set -eu
build=$1
skip() {
    echo "SKIPPED: $1"
    exit 77
}
command -v python3 >/dev/null || skip "python3 is not installed, so no link of docs/ was checked"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 docs/site.py check

# A broken link, a missing anchor and a hidden picture are found, links in code are not.
mkdir -p "$work/project/docs/pictures"
printf '# A\n\n[x](b.md) [y](#none) [z](#a)\n`[code](c.md)`\n\n```\n[block](d.md)\n```\n' >"$work/project/docs/a.md"
: >"$work/project/docs/pictures/hidden.png"
script=$(pwd)/docs/site.py
if (cd "$work/project" && python3 "$script" check) >"$work/found"; then
    echo "site.sh: faults were not found" && exit 1
fi
[ "$(sed 's/: .*//' "$work/found" | tr '\n' ' ')" = "docs/a.md docs/a.md docs/pictures/hidden.png " ] || {
    echo "site.sh: found instead of two links and a picture:" && cat "$work/found" && exit 1
}

command -v mkdocs >/dev/null || skip "mkdocs is not installed (./setup site installs it), so only the Markdown was checked"
python3 docs/site.py prepare "$build/reference" "$work"
mkdocs build --quiet --strict -f "$work/site.yml"
python3 docs/site.py verify "$work"

# Of a built page, a broken link, a missing anchor and a script from elsewhere are found.
mkdir -p "$work/small/site"
printf '<a href="b.html">b</a><a href="#none">c</a><script src="https://host/x.js"></script>' >"$work/small/site/a.html"
python3 docs/site.py verify "$work/small" >"$work/found" && echo "site.sh: faults of a page were not found" && exit 1
[ "$(grep -c '^a.html: ' "$work/found")" = 3 ] || {
    echo "site.sh: found instead of three faults:" && cat "$work/found" && exit 1
}
