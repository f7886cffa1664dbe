# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the Python package.

Classes, methods and signatures come from the stubs that the package installs. Texts come from the
comments in the headers, from which the docstrings of wrapped classes are made, too: docstrings lose
tables and lists, and the texts of methods that share one. Methods without a comment have their
docstring.
"""

import ast
import importlib
import inspect
import pathlib
import re
import textwrap

import airlight

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = pathlib.Path(airlight.__file__).parent
# What every VTK class has.
COMMON = {"GetNumberOfGenerationsFromBase", "GetNumberOfGenerationsFromBaseType", "IsA", "IsTypeOf",
          "NewInstance", "SafeDownCast", "__init__"}
# Parts of docstrings that are lists.
SECTIONS = {"Parameters", "Returns", "Raises", "Yields", "Attributes", "Warns"}
# Modules that are a program or only the wrapped code.
HIDDEN = {"__init__", "__main__"}

MACROS = (
    (re.compile(r"vtkSet\w*Macro\((\w+)"), ("Set{}",)),
    (re.compile(r"vtkGet\w*Macro\((\w+)"), ("Get{}",)),
    (re.compile(r"vtkBooleanMacro\((\w+)"), ("{}On", "{}Off")),
)
# The name of a declared method.
DECLARED = re.compile(
    r"(\w+)\([^()]*(?:\([^()]*\)[^()]*)*\)\s*(?:const)?\s*(?:override)?[;{]")
# A constant and its remark, which may go on in the next lines.
REMARK = re.compile(r"^\s+([A-Z][A-Z0-9_]+)(?:\s*=\s*\d+)?,?\s*///< *(.*(?:\n\s+///<.*)*)$",
                    re.MULTILINE)


def clean(comment):
    """The Markdown of a Doxygen comment."""
    lines = [re.sub(r"^\s*\* ?", "", line) for line in comment.strip("/* \n").splitlines()]
    text = "\n".join(line.rstrip() for line in lines).strip()
    text = re.sub(r"^@code\n(.*?)^@endcode$", r"\n```cpp\n\1```\n", text,
                  flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"^@(?:sa|see) (.*(?:\n\S.*)*)", r"See also: \1", text, flags=re.MULTILINE)


def names_in(code):
    """The methods that a piece of a header declares."""
    names = [pattern.format(name) for macro, patterns in MACROS for name in macro.findall(code)
             for pattern in patterns]
    return names + DECLARED.findall(code)


def read_header(name):
    """(comment of the class, {method: comment}, {constant: comment}) of a class's header."""
    paths = [path for folder in ("Module", "Filters", "Rendering")
             for path in (ROOT / folder).rglob(f"{name}.h")]
    if not paths:
        return "", {}, {}
    head, _, body = paths[0].read_text(encoding="utf-8").partition(f"\n#define {name}_h")
    found = re.search(r"/\*\*\s*\n \* @class.*?\*/", head, re.DOTALL)
    text = clean(found.group()) if found else ""
    text = re.sub(r"\A@class.*\n@brief +.*(\n\S.*)*\n", "", text)
    body = body.split("\nprotected:")[0].split("\nprivate:")[0]
    methods, constants = {}, {}
    pieces = re.split(r"(/\*\*.*?\*/|///@\{|///@\})", body, flags=re.DOTALL)
    comment, group = "", False
    for piece in pieces:
        if piece.startswith("/**"):
            comment = clean(piece)
        elif piece == "///@{":
            comment, group = "", True
        elif piece == "///@}":
            comment, group = "", False
        elif comment:
            code = re.sub(r"//.*", "", piece)
            # Outside a group the comment is that of the next declaration alone.
            part = code if group else code.split(";")[0] + ";"
            for method in names_in(part):
                methods.setdefault(method, []).append(comment)
        for constant, remark in REMARK.findall(piece):
            constants[constant] = re.sub(r"\s+///< *", " ", remark)
    methods = {key: "\n\n".join(dict.fromkeys(value)) for key, value in methods.items()}
    return text, methods, constants


def docstring_text(doc):
    """What a wrapped method's docstring says after its signatures."""
    return (doc or "").partition("\n\n")[2].strip()


def link_text(text, own, classes):
    """Text with links to classes, their methods and the pages."""
    def reference(match):
        name, method = match.group(1), match.group(2)
        if name not in classes or name == own and not method:
            return match.group()
        if method and method in classes[name]:
            return f"{{py:meth}}`{name}.{method}() <airlight.{name}.{method}>`"
        return f"{{py:class}}`~airlight.{name}`" + (f"::{method}()" if method else "")

    parts = re.split(r"(```.*?```|`[^`\n]*`)", text, flags=re.DOTALL)
    for index in range(0, len(parts), 2):
        part = re.sub(r"<(?=\w)", r"\\<", parts[index])
        part = re.sub(r"\b(vtk[A-Z]\w+)(?:::(\w+)(?:\(\))?)?", reference, part)
        parts[index] = re.sub(r"\bDocumentation/([\w-]+)\.md",
                              lambda m: f"[{m.group(1)}](../{m.group(1)}.md)"
                              if (ROOT / m.group()).exists() else m.group(), part)
    return "".join(parts)


def directive(level, kind, signatures, text, options=""):
    fence = ":" * level
    first, *rest = signatures if isinstance(signatures, list) else [signatures]
    head = "".join(f"\n{signature}" for signature in rest)
    return f"{fence}{{{kind}}} {first}{head}\n{options}\n{text}\n{fence}\n"


def signature(function):
    """The signature of a stub, without self and without quotes round names of types."""
    arguments = function.args
    static = any(getattr(name, "id", "") == "staticmethod" for name in function.decorator_list)
    if not static and arguments.args:
        del arguments.args[0]
    text = f"{function.name}({ast.unparse(arguments)})"
    if function.returns:
        text += f" -> {ast.unparse(function.returns)}"
    return text.replace("'", ""), static


def class_page(node, classes):
    name = node.name
    wrapped = getattr(airlight, name)
    text, comments, remarks = read_header(name)
    brief = " ".join((wrapped.__doc__ or "").split("\n\n")[0].split())
    text = text or docstring_text(wrapped.__doc__)
    base = ast.unparse(node.bases[0]) if node.bases else ""
    body = [f"A subclass of {{py:class}}`~airlight.{base}`." if base in classes
            else f"A subclass of VTK's `{base.rsplit('.', 1)[-1]}`.",
            f'In C++: <a href="../doxygen/class{name}.html">{name}</a>.\n',
            link_text(text, name, classes), ""]

    enums = [item.name for item in node.body if isinstance(item, ast.ClassDef)]
    for enum in enums:
        values = [item.target.id for item in node.body if isinstance(item, ast.AnnAssign)
                  and ast.unparse(item.annotation).strip("'") == enum]
        values.sort(key=lambda value: int(getattr(wrapped, value)))
        body.append(f"\nConstants, of the type `{enum}`:\n")
        for value in values:
            body.append(directive(4, "py:attribute", value,
                                  link_text(remarks.get(value, ""), name, classes),
                                  f":value: {int(getattr(wrapped, value))}\n"))

    functions = {}
    for item in node.body:
        if isinstance(item, ast.FunctionDef) and item.name not in COMMON:
            functions.setdefault(item.name, []).append(item)
    for method, overloads in functions.items():
        parts = [signature(item) for item in overloads]
        doc = comments.get(method) or docstring_text(getattr(wrapped, method).__doc__)
        body.append(directive(4, "py:method", [part[0] for part in parts],
                              link_text(doc, name, classes),
                              ":staticmethod:\n" if parts[0][1] else ""))

    properties = [item.target.id for item in node.body if isinstance(item, ast.AnnAssign)
                  and "getset_descriptor" in ast.unparse(item.annotation)]
    if properties:
        body.append("\nProperties, the same values in another spelling:\n")
        for value in properties:
            doc = " ".join((getattr(wrapped, value).__doc__ or "").split())
            body.append(f"- `{value}`: {doc}")
    page = f"# {name}\n\n{brief.partition(' - ')[2].capitalize()}.\n\n"
    page += directive(5, "py:class", f"airlight.{name}(**properties)", "\n".join(body))
    return page, brief.partition(" - ")[2]


def docstring_markdown(doc, indent=True):
    """A docstring as Markdown, which has the same rule for code: it is indented. A module's text is
    not indented by itself. In sections such as Parameters, indented text explains the line above.
    """
    text = inspect.cleandoc(doc or "") if indent else (doc or "").strip()
    # A session is code: Markdown would take its prompts for quotations.
    text = re.sub(r"^>>> .*(?:\n.+)*", lambda session: textwrap.indent(session.group(), "    "),
                  text, flags=re.MULTILINE)
    lines, section, entry = [], False, False
    for line, following in zip(text.splitlines(), [*text.splitlines()[1:], ""]):
        if re.fullmatch(r"-{4,}", following) and len(following) == len(line):
            section = line in SECTIONS
            lines += ["", f"**{line}**"]
        elif re.fullmatch(r"-{4,}", line):
            lines.append("")
        elif section and line and not line.startswith(" "):
            lines.append(f"- `{line}`:")
            entry = True
        elif section and entry:
            lines.append("  " + line.strip())
        else:
            lines.append(line if line.startswith("    ")
                         else re.sub(r"([*<])(?=\w)", r"\\\1", line))
    return "\n".join(lines)


def arguments_of(function):
    """The signature, without self and without defaults that are no Python."""
    text = str(inspect.signature(function))
    text = re.sub(r"\A\(self(, )?", "(", text)
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)  # annotations
    try:
        ast.parse(f"def f{text}: pass")
    except SyntaxError:
        return "(...)"
    return text


def module_page(name):
    """The page of a module in Python, or None if it cannot be imported here."""
    try:
        module = importlib.import_module(f"airlight.{name}")
    except ImportError as error:
        print(f"airlight.{name} has no page: {error}")
        return None
    doc = docstring_markdown(module.__doc__, indent=False)
    text = f"# airlight.{name}\n\n```{{py:module}} airlight.{name}\n```\n\n{doc}\n\n"
    for key, value in vars(module).items():
        own = getattr(value, "__module__", "") == module.__name__
        if key.startswith("_") or not (own or key in getattr(module, "__all__", ())):
            continue
        if inspect.isfunction(value):
            text += directive(4, "py:function", key + arguments_of(value),
                              docstring_markdown(value.__doc__)) + "\n"
        elif inspect.isclass(value):
            members = ""
            for member, function in vars(value).items():
                if member.startswith("_"):
                    continue
                if isinstance(function, property):
                    members += directive(4, "py:property", member,
                                         docstring_markdown(function.__doc__))
                elif inspect.isfunction(function):
                    members += directive(4, "py:method", member + arguments_of(function),
                                         docstring_markdown(function.__doc__))
            text += directive(5, "py:class", f"{module.__name__}.{key}",
                              docstring_markdown(value.__doc__) + "\n\n" + members) + "\n"
    return text, (module.__doc__ or "").strip().splitlines()[0]


def table(rows):
    lines = ["| name | purpose |", "|---|---|"]
    return "\n".join(lines + [f"| [{name}]({name}.md) | {brief} |" for name, brief in rows]) + "\n"


def write_pages(folder):
    folder.mkdir(parents=True)
    tree = ast.parse((PACKAGE / "vtkAirlight.pyi").read_text(encoding="utf-8"))
    nodes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
    classes = {node.name: {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
               - COMMON for node in nodes}
    modules, rows = [], []
    names = {path.stem for path in PACKAGE.glob("*.py")} | {
        path.parent.name for path in PACKAGE.glob("*/__init__.py")}
    for name in sorted(names - HIDDEN):
        page = None if name.startswith("_") else module_page(name)
        if page:
            (folder / f"airlight.{name}.md").write_text(page[0], encoding="utf-8")
            modules.append((f"airlight.{name}", page[1]))
    for node in sorted(nodes, key=lambda node: node.name):
        page, brief = class_page(node, classes)
        (folder / f"{node.name}.md").write_text(page, encoding="utf-8")
        rows.append((node.name, brief))
    text = ("# Python package\n\n```{py:module} airlight\n```\n\n"
            + docstring_markdown(airlight.__doc__.split("\nClasses:")[0], indent=False)
            + "\n\n## Modules\n\n" + table(modules) + "\n## Classes\n\n"
            "They are the C++ classes, with the same methods. Their pages leave out what every class\n"
            "of VTK has, such as `IsA()`.\n\n" + table(rows) + "\n```{toctree}\n:hidden:\n\n"
            + "\n".join(name for name, _ in modules + rows) + "\n```\n")
    (folder / "index.md").write_text(text, encoding="utf-8")
