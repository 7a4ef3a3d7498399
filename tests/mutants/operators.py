"""The faults: each is one change of one node of a file's syntax tree."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from typing import NamedTuple

COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
CALCULATED: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}
DROPPED = ast.Expr | ast.Assign | ast.AugAssign | ast.Raise | ast.Delete
HELD = ast.FunctionDef | ast.AsyncFunctionDef


class Mutant(NamedTuple):
    """A file with one fault."""

    line: int
    what: str
    source: str


def make_mutants(source: str) -> Iterator[Mutant]:
    """Yield a file once for each fault that can be put into its functions."""
    tree = ast.parse(source)
    strict = {
        keyword.value for keyword in ast.walk(tree) if isinstance(keyword, ast.keyword) and keyword.arg == "strict"
    }
    for number, node in enumerate(ast.walk(tree)):
        if node in strict:  # of zip(): lengths that are the same make no difference
            continue
        for what, _ in enumerate(list_faults(node)):
            changed = copy.deepcopy(tree)
            name = list_faults(next(n for i, n in enumerate(ast.walk(changed)) if i == number), what)[what]
            yield Mutant(getattr(node, "lineno", 0), name, ast.unparse(ast.fix_missing_locations(changed)))


def list_faults(node: ast.AST, chosen: int = -1) -> list[str]:
    """Return the names of a node's faults; the chosen one is put into it."""
    names = []
    for name, field, value, *at in _find_faults(node):
        if len(names) == chosen:
            if at:
                getattr(node, field)[at[0]] = value
            else:
                setattr(node, field, value)
        names.append(name)
    return names


def _find_faults(node: ast.AST) -> Iterator[tuple]:
    if isinstance(node, ast.Compare) and type(node.ops[0]) in COMPARED:
        other = COMPARED[type(node.ops[0])]
        yield f"{type(node.ops[0]).__name__} becomes {other.__name__}", "ops", other(), 0
    elif isinstance(node, ast.BinOp) and type(node.op) in CALCULATED:
        other = CALCULATED[type(node.op)]
        yield f"{type(node.op).__name__} becomes {other.__name__}", "op", other()
    elif isinstance(node, ast.BoolOp):
        other = ast.Or if isinstance(node.op, ast.And) else ast.And
        yield f"{type(node.op).__name__} becomes {other.__name__}", "op", other()
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float, bool):
        value = not node.value if isinstance(node.value, bool) else node.value + 1
        yield f"{node.value} becomes {value}", "value", value
    elif isinstance(node, ast.Return) and node.value is not None and not _is_false(node.value):
        yield "returns None", "value", ast.Constant(None)
    elif isinstance(node, ast.If | ast.IfExp):
        yield "the condition is turned round", "test", ast.UnaryOp(ast.Not(), node.test)
    yield from _find_dropped(node)


def _find_dropped(node: ast.AST) -> Iterator[tuple]:
    if not isinstance(node, HELD | ast.If | ast.For | ast.While | ast.With | ast.Try | ast.ExceptHandler):
        return
    for field in ("body", "orelse", "finalbody"):
        for place, statement in enumerate(getattr(node, field, ())):
            if isinstance(statement, DROPPED) and not _is_text(statement):
                yield f"drops: {ast.unparse(statement)[:70]}", field, ast.Pass(), place


def _is_false(value: ast.expr) -> bool:
    """Return whether a value is as false as None, so that it makes no difference where truth is all that counts."""
    return isinstance(value, ast.Constant) and not value.value


def _is_text(statement: ast.stmt) -> bool:
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)
