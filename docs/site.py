#!/usr/bin/env python3
"""Checks the pages of docs/, and builds a site of them by mkdocs. Run from the project's root.

    site.py check                     checks links, anchors and pictures of the Markdown
    site.py check REFERENCE           checks links and anchors of REFERENCE, and what names its pages
    site.py prepare REFERENCE FOLDER  writes FOLDER/site-src and FOLDER/site.yml for mkdocs
    site.py verify FOLDER             checks the built pages in FOLDER/site

docs/X.md becomes X.html. A linked file outside of docs/ becomes a page below source/: Markdown
as it is, other text as a block of code, a folder as a list of its files. REFERENCE is the folder
of the target `reference`: its pages are on the site, and link to others, as if they were in
docs/reference. In other pages `build/reference/X.md` becomes a link to the page X.md.
"""
import html.parser
import os
import re
import shutil
import sys
import urllib.parse

LINK = re.compile(r"(\]\()([^()\s]+)(\))")
NAMED = re.compile(r"\[[\w./-]+\.md\]\(([^()\s]+\.md(?:#[^()\s]*)?)\)")  # [page.md](page.md)
GENERATED = re.compile(r"`build/reference/([\w-]+\.md)`")
FENCE = re.compile(r"^\s*(```+)")
LANGUAGES = {".h": "c", ".c": "c", ".def": "c", ".glsl": "glsl", ".yaml": "yaml", ".json": "json",
             ".py": "python", ".sh": "sh", ".txt": "text", ".csv": "text", ".cmake": "cmake"}
SHELVES = (("guide", "Guides"), ("reference", "Reference"), ("design", "Design"),
           ("results", "Results"))
PICTURES = (".png", ".svg", ".jpg")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def files():
    """Returns the project's files without build folders."""
    found = []
    for folder, folders, names in os.walk("."):
        folders[:] = sorted(f for f in folders if not f.startswith((".", "build")))
        found += [os.path.relpath(os.path.join(folder, name)) for name in sorted(names)]
    return found


def replace_links(text, change):
    """Calls change(target) for each link outside of code; its result replaces the target."""
    lines, fence = [], ""
    for line in text.split("\n"):
        mark = FENCE.match(line)
        if mark and not fence:
            fence = mark[1]
        elif mark and mark[1] == fence and line.strip() == fence:
            fence = ""
        elif not fence:
            parts = re.split(r"(`[^`]*`)", line)
            for i in range(0, len(parts), 2):
                parts[i] = LINK.sub(lambda m: m[1] + change(m[2]) + m[3], parts[i])
            line = "".join(parts)
            if "`" in line:  # a link whose text contains code
                line = re.sub(r"(`\]\()([^()\s]+)(\))",
                              lambda m: m[1] + change(m[2]) + m[3], line)
        lines.append(line)
    return "\n".join(lines)


def links_of(text):
    """Returns the targets of a page's links."""
    targets = []
    replace_links(text, lambda target: targets.append(target) or target)
    return targets


def anchors(text):
    """Returns the anchors of a page's headings, as GitHub and docs/mkdocs.yml make them."""
    found, fence = set(), ""
    for line in text.split("\n"):
        mark = FENCE.match(line)
        if mark:
            fence = "" if fence == mark[1] else fence or mark[1]
        elif not fence and re.match(r"#+ ", line):
            title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip())
            found.add(re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-"))
        elif not fence:
            found.update(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", line))
    return found


def is_outside(target):
    return bool(urllib.parse.urlsplit(target).scheme)


def resolve(page, target):
    """Returns the path that a link of a page names, and its anchor."""
    path, _, anchor = urllib.parse.unquote(target).partition("#")
    return (os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page), anchor


def generated(reference):
    """Returns the files of the folder REFERENCE by their places in docs/reference."""
    found = {}
    for folder, _, names in os.walk(reference):
        for name in sorted(names):
            if name.endswith((".md",) + PICTURES):
                path = os.path.join(folder, name)
                found["docs/reference/" + os.path.relpath(path, reference)] = path
    return found


def link_generated(page, text, made):
    """Turns names of generated pages in the text of a page into links."""
    def link(match):
        path = "docs/reference/" + match[1]
        if path not in made:
            return match[0]
        return f"[{title_of(read(made[path]))}]({os.path.relpath(path, os.path.dirname(page))})"
    return GENERATED.sub(link, text)


def check_generated(reference):
    """Prints links of generated pages that lead nowhere, and names of pages that do not exist;
    returns their number. Pictures may be absent: tests/docs/pictured.sh checks them."""
    made, faults = generated(reference), []
    pages = [page for page in made if page.endswith(".md")]
    for page in pages:
        for target in links_of(read(made[page])):
            path, anchor = resolve(page, target)
            if is_outside(target) or path.startswith("docs/reference/pictures/"):
                continue
            if path not in made and not os.path.exists(path):
                faults.append(f"{made[page]}: {target} does not exist")
            elif anchor and anchor not in anchors(read(made.get(path, path))):
                faults.append(f"{made[page]}: {target} has no such heading")
    for page in (name for name in files() if name.endswith(".md")):
        faults += [f"{page}: the target `reference` makes no {name}"
                   for name in GENERATED.findall(read(page)) if "docs/reference/" + name not in made]
    if not pages:
        faults.append(f"{reference}: no pages")
    print("\n".join(faults), end="\n" if faults else "")
    return len(faults)


def check():
    """Prints links that lead nowhere and pictures that no page shows; returns their number."""
    faults, shown = [], set()
    all_files = files()
    for page in (name for name in all_files if name.endswith(".md")):
        for target in links_of(read(page)):
            if is_outside(target):
                continue
            path, anchor = resolve(page, target)
            shown.add(path)
            if not os.path.exists(path):
                faults.append(f"{page}: {target} does not exist")
            elif anchor and path.endswith(".md") and anchor not in anchors(read(path)):
                faults.append(f"{page}: {target} has no such heading")
    for name in all_files:
        if name.startswith("docs/pictures/") and name.endswith(PICTURES) and name not in shown:
            faults.append(f"{name}: no page shows it")
    print("\n".join(faults), end="\n" if faults else "")
    return len(faults)


def title_of(text):
    match = re.search(r"^# (.*)$", text, re.M)
    return match[1] if match else ""


def page_of_file(path):
    """Returns the text of a page that shows a file or folder."""
    if os.path.isdir(path):
        rows = "".join(f"- [{name}]({name})\n" for name in sorted(os.listdir(path))
                       if not name.startswith("."))
        return f"# {path}/\n\n{rows}"
    language = LANGUAGES.get(os.path.splitext(path)[1], "text")
    text = read(path)
    fence = "`" * (max([2] + [len(run) for run in re.findall(r"^`+", text, re.M)]) + 1)
    return f"# {os.path.basename(path)}\n\n`{path}`\n\n{fence}{language}\n{text}\n{fence}\n"


class Site:
    """Copies pages, and everything that they link to, below a folder."""

    def __init__(self, folder, made):
        self.folder = folder
        self.made = made  # generated files by their places in docs/reference
        self.places = {}  # a file or folder of the project: its place in the site
        self.waiting = []
        self.titles = {}

    def place(self, path):
        """Returns where a file of the project is in the site, and has it written there."""
        if os.path.isdir(path) and os.path.exists(os.path.join(path, "README.md")):
            path = os.path.join(path, "README.md")
        if path not in self.places:
            inside = path.startswith("docs/")
            place = path[len("docs/"):] if inside else "source/" + path
            if place.endswith("README.md"):
                place = place[:-len("README.md")] + "index.md"
            elif os.path.isdir(path):
                place += "/index.md"
            elif not path.endswith((".md",) + PICTURES + (".glb", ".bin")):
                place += ".md"
            self.places[path] = place
            self.waiting.append(path)
        return self.places[path]

    def link(self, page, target, place):
        if is_outside(target):
            return target
        path, anchor = resolve(page, target)
        if path.startswith(".."):
            return target
        if path == page:
            return target
        found = os.path.relpath(self.place(path), os.path.dirname(place))
        return found + ("#" + anchor if anchor else "")

    def title_at(self, page, target):
        """Returns the title of the page that a link leads to."""
        path = resolve(page, target)[0]
        path = self.made.get(path, path)
        return title_of(read(path)) if os.path.isfile(path) else ""

    def copy(self):
        while self.waiting:
            path = self.waiting.pop(0)
            place = self.places[path]
            full = os.path.join(self.folder, place)
            if not place.endswith(".md"):
                os.makedirs(os.path.dirname(full), exist_ok=True)
                shutil.copyfile(self.made.get(path, path), full)
                continue
            is_source = not path.endswith(".md")
            text = page_of_file(path) if is_source else read(self.made.get(path, path))
            page = os.path.join(path, "index.md") if os.path.isdir(path) else path
            if not is_source:
                text = link_generated(page, text, self.made)
            text = NAMED.sub(lambda m: f"[{self.title_at(page, m[1]) or m[1]}]({m[1]})", text)
            self.put(place, replace_links(text, lambda t: self.link(page, t, place)), is_source)

    def put(self, place, text, is_source):
        self.titles[place] = title_of(text)
        head = "---\nsearch:\n  exclude: true\nhide: [toc]\n---\n" if is_source else ""
        write(os.path.join(self.folder, place), head + text.replace("<details>", "<details markdown>"))


def quoted(text):
    return "'" + text.replace("`", "").replace("'", "''") + "'"


def nav(site):
    """Returns the navigation: the pages of each shelf in the order of docs/README.md."""
    text = link_generated("docs/README.md", read("docs/README.md"), site.made)
    order = [target.partition("#")[0] for target in links_of(text)]
    lines = ["nav:", "  - Home: index.md"]
    for shelf, title in SHELVES:
        lines.append(f"  - {title}:")
        places = [p for p in site.titles
                  if p.startswith(shelf + "/") and site.titles[p] and not p.endswith((".csv.md",))]
        for place in sorted(places, key=lambda p: (order.index(p) if p in order else 999, p)):
            label = site.titles[place]
            alike = [p for p in site.titles if p.startswith(shelf + "/") and site.titles[p] == label]
            if len(alike) > 1 and "-" in place:
                label += f" ({os.path.splitext(os.path.basename(place))[0]})"
            lines.append(f"      - {quoted(label)}: {place}")
    lines.append("  - Source:")
    for path in ("README.md", "CONTRIBUTING.md", "examples", "grammar", "compiler", "runtime",
                 "tests"):
        place = site.place(path)
        lines.append(f"      - {quoted(path)}: {place}")
    return "\n".join(lines) + "\n"


def prepare(reference, folder):
    source = os.path.join(folder, "site-src")
    shutil.rmtree(source, ignore_errors=True)
    site = Site(source, generated(reference))
    for name in files() + [name for name in site.made if name.endswith(".md")]:
        if name.startswith("docs/") and name.endswith((".md",) + PICTURES):
            site.place(name)
    for path in ("README.md", "CONTRIBUTING.md", "examples", "grammar", "compiler", "runtime",
                 "tests"):
        site.place(path)
    site.copy()
    write(os.path.join(folder, "site.yml"),
          read("docs/mkdocs.yml") + f"docs_dir: {source}\nsite_dir: {folder}/site\n" + nav(site))


class Page(html.parser.HTMLParser):
    """Collects the anchors and the links of a built page."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.images, self.loaded = set(), [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.ids.update(v for k, v in attrs if k in ("id", "name") and v)
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        elif tag == "img" and values.get("src"):
            self.images.append(values["src"])
        if tag in ("img", "script", "link", "iframe", "source"):
            self.loaded += [values[k] for k in ("src", "href") if values.get(k)]


def verify(folder):
    """Prints faults of the built site: links, anchors, and what comes from elsewhere."""
    root = os.path.join(folder, "site")
    pages, faults, shown = {}, [], set()
    for place, _, names in os.walk(root):
        for name in names:
            if name.endswith(".html"):
                path = os.path.join(place, name)
                pages[path] = Page(read(path))
    for path, page in pages.items():
        name = os.path.relpath(path, root)
        if name == "404.html":  # its links begin with the address of the host
            continue
        for target in page.loaded:
            if re.match(r"(https?:)?//", target):
                faults.append(f"{name}: loads {target}")
        for target in page.links + page.loaded:
            if is_outside(target) or target.startswith("//"):
                continue
            to, anchor = resolve(path, target.partition("?")[0])
            shown.add(os.path.relpath(to, root))
            if not os.path.isfile(to):
                faults.append(f"{name}: {target} does not exist")
            elif anchor and to in pages and anchor not in pages[to].ids | {"__top"}:
                faults.append(f"{name}: {target} has no such anchor")
    for name in files():
        if name.startswith("docs/pictures/") and name.endswith(PICTURES):
            if name[len("docs/"):] not in shown:
                faults.append(f"{name}: no page of the site shows it")
    if len(pages) < 20:
        faults.append(f"{root}: only {len(pages)} pages")
    print("\n".join(sorted(set(faults))), end="\n" if faults else "")
    return len(faults)


def main():
    if sys.argv[1:] == ["check"]:
        return 1 if check() else 0
    if len(sys.argv) == 3 and sys.argv[1] == "check":
        return 1 if check_generated(sys.argv[2]) else 0
    if len(sys.argv) == 4 and sys.argv[1] == "prepare":
        prepare(sys.argv[2], os.path.abspath(sys.argv[3]))
        return 0
    if len(sys.argv) == 3 and sys.argv[1] == "verify":
        return 1 if verify(os.path.abspath(sys.argv[2])) else 0
    print(__doc__)
    return 2


sys.exit(main())
