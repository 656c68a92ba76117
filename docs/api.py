#!/usr/bin/env python3
"""Prints the reference page of a public header: api.py HEADER >PAGE. Run from the project's root.

The header's first comment becomes the introduction, `/* -- Title */` a section. A comment and
the declarations below it, up to a blank line or the next comment, become an entry: their names,
signatures and the comment. Members of structs and enums become a list.
"""
import os
import re
import sys
import textwrap

CODE = re.compile(r'(`[^`]*`|"[^"]*")')
WORDS = re.compile(r"(?<![\w/.\"])(\*+[a-z]\w*|matc_[a-z]\w*(?:\(\))?|_[a-z]\w*\(\)|MATC_[A-Z]\w*"
                   r"|Matc[A-Z]\w*(?:\.\w+)?|libmatc\w*(?:\.so)?|NULL|GL_\w+|[a-z]+_[a-z_]\w*)(?!\w|\.h)")
PAGE = re.compile(r"(?:docs|build)/reference/([\w-]+\.md)")


def marked(text):
    """Puts identifiers into backquotes and links pages."""
    parts = CODE.split(text)
    for i in range(0, len(parts), 2):
        parts[i] = WORDS.sub(r"`\1`", PAGE.sub(r"[\1](\1)", parts[i])).replace("<", "&lt;")
    return "".join(parts)


def comment_text(lines):
    """Returns the lines of a comment without its marks."""
    text = "\n".join(lines).strip()
    text = re.sub(r"^/\*|\*/$", "", text)
    return [re.sub(r"^ *\* ?", "", line).rstrip() if i else line.strip()
            for i, line in enumerate(text.split("\n"))]


def wrapped(text, indent=""):
    return textwrap.fill(text, 100, break_on_hyphens=False, break_long_words=False,
                         subsequent_indent=indent)


def prose(lines):
    """Returns paragraphs, and blocks of code for what is indented."""
    blocks = []
    for block in re.split(r"\n\s*\n", "\n".join(lines)):
        for part in re.split(r"((?:^ {4}.*(?:\n|$))+)", block, flags=re.M):
            if part.startswith("    "):
                blocks.append("```c\n" + textwrap.dedent(part).rstrip() + "\n```")
            elif part.strip():
                blocks.append(wrapped(marked(" ".join(part.split()))))
    return "\n\n".join(blocks) + "\n"


def spaced(text):
    return re.sub(r" +([,;)])|(\*) +", r"\1\2", " ".join(text.split()))


def members(body):
    """Returns (declaration, comment) of each member of a struct or enum."""
    found, code, notes, ended = [], "", [], False
    for token in re.findall(r"/\*.*?\*/|\n|[;,(){}\[\]]|[^;,(){}\[\]/\n]+|/", body, re.S):
        if token.startswith("/*"):
            text = " ".join(comment_text(token.split("\n"))).strip()
            if ended and found:
                found[-1][1].append(text)
            else:
                notes.append(text)
        elif token == "\n":
            ended = False
        elif token in ";," and code.count("(") == code.count(")") and (
                token == ";" or IN_ENUM[0]):
            found.append((spaced(code), notes))
            code, notes, ended = "", [], True
            continue
        if not token.startswith("/*"):
            code += token if token != "\n" else " "
    if code.strip():
        found.append((spaced(code), notes))
    return [(code, " ".join(notes)) for code, notes in found if code]


IN_ENUM = [False]  # whether commas end a member


def type_page(declaration):
    """Returns the entry of a struct or enum: its members as a list."""
    IN_ENUM[0] = "enum" in declaration.split("{")[0]
    body = declaration[declaration.index("{") + 1:declaration.rindex("}")]
    rows = ""
    for code, note in members(body):
        rows += wrapped(f"- `{code}`" + (f": {marked(note)}" if note else ""), "  ") + "\n"
    return rows


def name_of(declaration):
    define = re.match(r"#define (\w+)", declaration)
    if define:
        return define[1]
    if declaration.startswith("typedef") and "{" in declaration:
        return re.search(r"}\s*(\w+);", declaration)[1]
    if declaration.startswith("enum"):
        return ", ".join(re.findall(r"(\w+) =", declaration))
    pointer = re.search(r"\(\*(\w+)\)", declaration)
    if declaration.startswith("typedef"):
        return pointer[1] if pointer else re.search(r"(\w+);", declaration)[1]
    return re.search(r"(\w+)\(", declaration)[1] + "()"


def parsed(text):
    """Yields ("section", title), ("blank",), ("comment", lines) and ("code", declaration)."""
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        line = lines[i]
        if not line.strip():
            yield ("blank", None)
        elif line.startswith("/*"):
            first = i
            while "*/" not in lines[i]:
                i += 1
            found = comment_text(lines[first:i + 1])
            if found[0].startswith("-- "):
                yield ("section", " ".join(found)[3:])
            else:
                yield ("comment", found)
        elif line.startswith("#if") or line.startswith("#endif") or line.startswith("#else"):
            pass
        elif not line.startswith(("#include", "#define MATC_API")):
            first = i
            while True:
                code = re.sub(r"/\*.*?\*/", "", "\n".join(lines[first:i + 1]), flags=re.S)
                if line.startswith("#") or ("/*" not in code and code.count("{") == code.count("}")
                                            and code.rstrip().endswith(";")):
                    break
                i += 1
            yield ("code", "\n".join(lines[first:i + 1]))
        i += 1


def entry_text(codes, note):
    """Returns the entry of some declarations and their comment, as Markdown."""
    if not codes:
        return ""
    names = [name_of(code) for code in codes]
    text = "\n### " + ", ".join(names) + "\n"
    is_type = "{" in codes[0]
    if not is_type:
        plain = [re.sub(r"\bMATC_API ", "", code) for code in codes]
        text += "\n```c\n" + "\n".join(aligned(code) for code in plain) + "\n```\n"
    if note:
        text += "\n" + prose(note)
    if is_type:
        text += "\n" + type_page(codes[0])
    return text


def aligned(code):
    """Returns a declaration on lines of at most 90 columns, its arguments below each other."""
    trailing = "".join(re.findall(r"/\*.*?\*/", code))
    one = spaced(re.sub(r"/\*.*?\*/", "", code))
    if trailing:
        one += " " + trailing
    if len(one) > 90 and "(" in one and not one.startswith("#"):
        start = one.rindex("(") + 1
        one = textwrap.fill(re.sub(r"(?<!,) ", "\0", one), 90, subsequent_indent=" " * start,
                            break_on_hyphens=False).replace("\0", " ")
    return one


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        text = file.read()
    banner = text[:text.index("*/") + 2]
    body = text[text.index("*/") + 2:text.rindex("#ifdef __cplusplus")]
    body = re.sub(r"#ifdef __cplusplus\n.*?#endif\n", "", body, flags=re.S)
    print(f"# {os.path.basename(path)}\n\n<!-- Made from {path} by docs/api.py -->\n")
    print(prose(comment_text(banner.split("\n"))), end="")
    codes, note = [], None
    for kind, value in parsed(body.replace("#ifndef MATC_H\n#define MATC_H\n", "")
                              .replace("#ifndef MATC_RENDERER_HOST_H\n"
                                       "#define MATC_RENDERER_HOST_H\n", "")):
        if kind == "code":
            if codes and ("{" in codes[0] or "{" in value):
                print(entry_text(codes, note), end="")
                codes, note = [], None
            codes.append(value)
            continue
        print(entry_text(codes, note), end="")
        codes = []
        note = value if kind == "comment" else None
        if kind == "section":
            title, _, more = value.partition(": ")
            if more and " " in more.split("_")[0]:
                more = more[0].upper() + more[1:]
            print(f"\n## {title}\n" + (f"\n{marked(more)}.\n" if more else ""), end="")
    print(entry_text(codes, note), end="")


main()
