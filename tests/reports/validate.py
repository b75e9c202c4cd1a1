"""Validates JSON documents against a schema: validate.py SCHEMA DOCUMENT...

Prints one line a document, "valid NAME" or "invalid NAME: where: why", with python3-jsonschema, which shares no code with
the validator of the C++ tests. Exit code 0 unless something cannot be read or the schema itself is none.
"""

import json
import sys

import jsonschema


def main(schema_path, document_paths):
    with open(schema_path, encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    for path in document_paths:
        with open(path, encoding="utf-8") as file:
            error = next(validator.iter_errors(json.load(file)), None)
        if error is None:
            print("valid", path)
        else:
            where = "/".join(map(str, error.absolute_path))
            print(f"invalid {path}: /{where}: {error.message[:200]}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
