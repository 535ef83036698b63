#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Validates reports against their JSON Schema: validate.py SCHEMA REPORT...

Prints the first errors of each report as `file:/json/pointer: what is wrong`. The exit status is 0
if all reports are valid, 1 if one is not, and 2 if the schema or a report cannot be read.
"""

import json
import sys

ERRORS_SHOWN = 5


def read(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError) as error:
        print(f"{path}: cannot be read: {error}", file=sys.stderr)
        sys.exit(2)


def describe(path, error):
    pointer = "".join(f"/{part}" for part in error.absolute_path) or "/"
    return f"{path}:{pointer}: {error.message[:200]}"


def main(arguments):
    if len(arguments) < 2:
        print("usage: validate.py SCHEMA REPORT...", file=sys.stderr)
        return 2
    try:
        from jsonschema import Draft202012Validator
    except ImportError:
        print("validate.py: needs the package python3-jsonschema", file=sys.stderr)
        return 2
    schema = read(arguments[0])
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    valid = True
    for path in arguments[1:]:
        errors = sorted(validator.iter_errors(read(path)), key=lambda error: describe(path, error))
        for error in errors[:ERRORS_SHOWN]:
            print(describe(path, error))
        valid = valid and not errors
    return 0 if valid else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
