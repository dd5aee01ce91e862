#!/usr/bin/env python3
"""Validates JSON against a JSON Schema.   exit 77: no module jsonschema

validate_json.py SCHEMA FILE...                    the files
validate_json.py SCHEMA --run COMMAND ARGUMENT...  what the command prints

$KNITTSIM_SARIF_SCHEMA names the whole schema of SARIF 2.1.0 where one has it; what a command prints must then satisfy it
as well.
"""
import json
import os
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("the Python module jsonschema is not installed")
    sys.exit(77)


def problems(schema_file, name, document):
    with open(schema_file, encoding="utf-8") as file:
        schema = json.load(file)
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return [f"{name}: {e.json_path}: {e.message[:200]}" for e in kind(schema).iter_errors(document)]


def main():
    schema, *rest = sys.argv[1:]
    found = []
    if rest[0] == "--run":
        run = subprocess.run(rest[1:], stdout=subprocess.PIPE, check=False)
        document = json.loads(run.stdout)
        for file in filter(None, (schema, os.environ.get("KNITTSIM_SARIF_SCHEMA"))):
            found += problems(file, file, document)
    else:
        for path in rest:
            with open(path, encoding="utf-8") as file:
                found += problems(schema, path, json.load(file))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
