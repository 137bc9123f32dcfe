#!/usr/bin/env python3
"""Holds viz/lang/isect.pot, and the .po files of all languages, to what the sources say.

    keys.py [--write]

The texts are the literals in calls of tr, tr_as, tr_count, tr_names, message, message_as and message_count in app/ and
viz/. --write writes the template anew; then `msgmerge --update viz/lang/de.po viz/lang/isect.pot` brings a language to
it.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CALL = re.compile(r'\b(tr|tr_as|tr_count|tr_names|message|message_as|message_count)\(')
LITERALS = r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*'


def value(literals):
    """Returns the text of adjacent literals, as a .po file writes it, without quotes."""
    return ''.join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))


def keys_of(text):
    """Returns (context, one, other) of each call whose texts are literals."""
    found = []
    for call in CALL.finditer(text):
        name, at = call[1], call.end()
        if name == 'tr_count':  # behind the number, if there is one
            depth = 0
            while at < len(text) and not (text[at] == ',' and depth == 0):
                depth += text[at] in '([{'
                depth -= text[at] in ')]}'
                at += 1
            at += 1
        several = 2 if name in ('tr_as', 'tr_count', 'message_as', 'message_count') else 1
        match = re.match(r'\s*' + r'\s*,\s*'.join([f'({LITERALS})'] * several), text[at:])
        if not match:
            continue
        texts = [value(part) for part in match.groups()]
        if name.endswith('_as'):
            found.append((texts[0], texts[1], ''))
        else:
            found.append(('', texts[0], texts[1] if several == 2 else ''))
    return found


def all_keys():
    """Returns the keys in their order, each once, with the file that says them first."""
    keys = {}
    for ring in ('app', 'viz'):
        for path in sorted((ROOT / ring).rglob('*')):
            if path.suffix not in ('.cpp', '.h') or path.parts[-2] == 'lang':
                continue
            for key in keys_of(path.read_text(encoding='utf-8')):
                keys.setdefault(key, path.relative_to(ROOT).as_posix())
    return keys


def template(keys):
    out = ('# The texts of isect, of which translations are made. Written by tests/lang/keys.py --write.\n'
           'msgid ""\nmsgstr ""\n"Content-Type: text/plain; charset=UTF-8\\n"\n'
           '"Plural-Forms: nplurals=2; plural=n != 1;\\n"\n')
    for (context, one, other), path in keys.items():
        out += f'\n#: {path}\n'
        if context:
            out += f'msgctxt "{context}"\n'
        out += f'msgid "{one}"\n'
        out += f'msgid_plural "{other}"\nmsgstr[0] ""\nmsgstr[1] ""\n' if other else 'msgstr ""\n'
    return out


def main():
    keys = all_keys()
    pot = ROOT / 'viz' / 'lang' / 'isect.pot'
    told = template(keys)
    clashes = [one for (context, one, other) in keys if other and (context, one, '') in keys]
    if clashes:
        sys.exit(f'these stand alone and count, too, which gettext forbids: {clashes}')
    if '--write' in sys.argv[1:]:
        pot.write_text(told, encoding='utf-8')
        print(f'{len(keys)} texts')
    elif not pot.exists() or pot.read_text(encoding='utf-8') != told:
        sys.exit('viz/lang/isect.pot is not what the sources say; write it by tests/lang/keys.py --write, then bring '
                 'each language to it by msgmerge --update viz/lang/de.po viz/lang/isect.pot')


if __name__ == '__main__':
    main()
