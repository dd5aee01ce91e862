#!/usr/bin/env python3
"""Every error that the open knitout interpreter finds, `knittsim-cli check` finds as well, or REASONS says why not.

compare_interpreter.py CLI PROFILES PROGRAMS MACHINE_DATA   exit 77: the interpreter is not installed

PROFILES holds a machine with the interpreter's own limits. $KNITTSIM_MACHINE_DATA names another MACHINE_DATA. The interpreter reads less than knitout 2, so it is given a
copy of each program, line by line, without what it does not know (extensions, some headers, negative needles, names of
carriers, knit without carriers). It stops at its first error. It is slow, so long programs are left out.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

try:
    from knitout_interpreter.run_knitout import run_knitout
except ImportError:
    print("knitout-interpreter is not installed: pip install knitout-interpreter")
    sys.exit(77)

# What the interpreter raises or warns of -> our rules, any of which will do.
RULES = {
    "Use_Inactive_Carrier_Error": {"KS0201"},
    "Inserting_Hook_In_Use_Error": {"KS0204"},
    "Hooked_Carrier_Error": {"KS0204", "KS0213"},
    "Blocked_by_Yarn_Inserting_Hook_Error": {"KS0217"},
    "Max_Rack_Error": {"KS0218"},
    "Slider_Loop_Error": {"KS0209"},
    "leftward direction": {"KS0216"},
    "Cannot Xfer": {"KS0206", "KS0207"},
    "Cannot Split": {"KS0206", "KS0207"},
    "because they are on the same bed": {"KS0207"},
    "is not on the": {"KS0220", "KS0208"},
    "list index out of range": {"KS0220", "KS0208"},
    "Invalid carrier": {"KS0241", "KS0109"},
    "slider": {"KS0223"},
    "Knitout_ParseError": {"KS0107", "KS0108", "KS0109", "KS0110", "KS0118", "KS0119"},
    "In_Active_Carrier_Warning": {"KS0202"},
    "Out_Inactive_Carrier_Warning": {"KS0203"},
    "Duplicate_Carriers_In_Set": {"KS0110"},
    "Mismatched_Releasehook_Warning": {"KS0205"},
    "Long_Float_Warning": {"KS0233"},
    "Needle_Holds_Too_Many_Loops": {"KS0231"},
    "Knit_on_Empty_Needle_Warning": {"KS0228"},
}

# What it says and we do not (patterns), and why.
REASONS = {
    r"In_Loose_Carrier_Warning": "knitout 2 has 'in' for yarns that grippers hold; machines without hook know no other",
    r"ParseError.*<(in|out|inhook|outhook|releasehook) \d+ ": "its grammar has one carrier here, knitout 2 has a set",
}

MAX_BYTES = 40_000  # of a program


def readable_copy(text):
    """The program as the interpreter can read it, line numbers unchanged."""
    bodies = [line.split(";")[0].split() for line in text.splitlines()]
    needles = [int(n) for body in bodies for n in re.findall(r"\b[fb]s?(-?\d+)", " ".join(body))]
    shift = -min(needles + [0])
    header = re.search(r"^;;Carriers:(.*)$", text, re.M)
    names = {name: str(i) for i, name in enumerate(re.split(r"[\s,;]+", header[1].strip()) if header else [], 1)}
    lines = [";!knitout-2", ";;Carriers: " + " ".join(names.values())]
    for body in bodies[2:]:
        if not body or body[0].startswith("x-"):
            lines.append("; no operation")
        elif body[0] == "rack":
            lines.append(f"rack {float(body[1]):g}")
        elif body[0] == "knit" and len(body) == 3:
            lines.append(f"drop {moved(body[2], shift)}")
        else:
            lines.append(" ".join([body[0], *(moved(names.get(word, word), shift) for word in body[1:])]))
    return "\n".join(lines) + "\n"


def moved(word, shift):
    needle = re.fullmatch(r"([fb]s?)(-?\d+)", word)
    return needle[1] + str(int(needle[2]) + shift) if needle else word


def cause(error):
    while getattr(error, "error", None) is not None:
        error = error.error
    return error


def interpreter_findings(path):
    """(line or None, text) of all its warnings and of its first error."""
    findings = []
    with tempfile.NamedTemporaryFile("w", suffix=".k", encoding="utf-8") as copy:
        copy.write(readable_copy(path.read_text(encoding="utf-8", errors="replace")))
        copy.flush()
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            try:
                run_knitout(copy.name)
            except Exception as error:  # whatever it raises is a finding
                line = getattr(error, "line_number", None)  # counted from 0
                inner = cause(error)
                findings.append((None if line is None else line + 1, f"{type(inner).__name__}: {inner}"))
        for warning in told:
            if type(warning.message).__module__.startswith(("knitout_interpreter", "virtual_knitting")):
                findings.append((None, f"{type(warning.message).__name__}: {warning.message}"))
    return findings


def our_findings(cli, profiles, files):
    run = subprocess.run([cli, "check", "--format", "json", "--machine", "interpreter", *map(str, files)],
                         env={**os.environ, "KNITTSIM_MACHINES": profiles}, stdout=subprocess.PIPE, check=False)
    report = json.loads(run.stdout)
    return {f["file"]: [(x["line"], x["rule"]) for x in f["findings"]] for f in report["files"]}


def rules_for(text):
    return next((rules for key, rules in RULES.items() if key.lower() in text.lower()), None)


def main():
    cli, profiles, programs, machine_data = sys.argv[1:]
    folders = (programs, os.environ.get("KNITTSIM_MACHINE_DATA", machine_data))
    files = sorted(p for folder in folders for p in Path(folder).rglob("*")
                   if p.suffix in (".k", ".knitout") and p.stat().st_size <= MAX_BYTES)
    ours = our_findings(cli, profiles, files)
    compared, missing = 0, []
    seen = {}
    for path in files:
        for line, text in dict.fromkeys(interpreter_findings(path)):
            compared += 1
            name = text.split(":")[0]
            seen[name] = seen.get(name, 0) + 1
            if any(re.search(key, text, re.S) for key in REASONS):
                continue
            wanted = rules_for(text)
            found = ours[str(path)]
            if wanted is None or not any(rule in wanted and line in (None, at) for at, rule in found):
                missing.append(f"{path.name}:{line}: {text[:160]!r}; we say {sorted(set(found))[:8]}")
    print(f"{len(files)} programs, {compared} findings of the interpreter compared: {seen}")
    for text in missing:
        print("not found:", text)
    return 1 if missing or not files else 0


if __name__ == "__main__":
    sys.exit(main())
