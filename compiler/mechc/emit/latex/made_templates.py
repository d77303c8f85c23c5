"""The templates of this folder as functions, made by ``mechc.emit.make_templates``."""

from collections.abc import Mapping
from typing import Any

from ..render import turns


def _body(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    labelled = list([_one for _one in _known["parameters"] if _one.label])
    ranged = list([_one for _one in _known["parameters"] if _one.range])
    _parts += [TEMPLATES['latex/head.jinja']({**_known, "labelled": labelled, "ranged": ranged})]
    _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].given), '}\n']
    for line in _known["pictures"].scheme:
        _parts += [str(line), '\n']
    if (_known["scheme"] or _known["vectors"]):
        _parts += ['\\noindent ', str(_known["conventions"]), '\n']
    if _known["scheme"]:
        _parts += ['\\begin{itemize}\\setlength{\\itemsep}{0pt}\\setlength{\\parskip}{0pt}\n']
        for sentence in _known["scheme"]:
            _parts += ['  \\item ', str(sentence), '\n']
        _parts += ['\\end{itemize}\n']
    if _known["parameters"]:
        _parts += [TEMPLATES['latex/given.jinja']({**_known, "labelled": labelled, "ranged": ranged})]
    if _known["vectors"]:
        if (not list([_one for _one in _known["vectors"] if _one.direction])):
            _parts += [TEMPLATES['latex/coordinates_abreast.jinja']({**_known, "labelled": labelled, "ranged": ranged})]
        elif (len(_known["vectors"]) > 6):
            _parts += [TEMPLATES['latex/vectors_abreast.jinja']({**_known, "labelled": labelled, "ranged": ranged})]
        else:
            _parts += ['\\begin{longtable}[l]{@{}>{\\raggedright\\arraybackslash}p{0.17\\linewidth}>{\\raggedright\\arraybackslash}p{0.37\\linewidth}>{\\raggedright\\arraybackslash}p{\\dimexpr0.36\\linewidth+2\\tabcolsep}@{}}\n\\toprule\n', str(_known["locale"].vector), ' & ', str(_known["locale"].length), ' & ', str(_known["locale"].direction), ' \\\\\n\\midrule\n\\endhead\n']
            for row in _known["vectors"]:
                _parts += [str(row.vector), ' & ', str(row.length), ' & ', str(row.direction), ' \\\\*\n']
            _parts += ['\\bottomrule\n\\end{longtable}\n']
    _parts += [TEMPLATES['latex/tables.jinja']({**_known, "labelled": labelled, "ranged": ranged})]
    if _known["position"]:
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].position), '}\n']
        if (len(_known["position"]) > 1):
            _parts += ['\\begin{enumerate}\n']
        for step in _known["position"]:
            if (len(_known["position"]) > 1):
                _parts += ['  \\item ']
            _parts += [str(step.sentence), '\n']
            for display in step.displays:
                _parts += [str(display), '\n']
        if (len(_known["position"]) > 1):
            _parts += ['\\end{enumerate}\n']
    if _known["steps"]:
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].velocities), '}\n', str(_known["convention_of_speeds"]), '\n']
        if (len(_known["steps"]) > 1):
            _parts += ['\\begin{enumerate}\n']
        else:
            _parts += ['\\par\\smallskip\\noindent\n']
        for step in _known["steps"]:
            if (len(_known["steps"]) > 1):
                _parts += ['  \\item ']
            _parts += [str(step.sentence), '\n']
            if (step.relations and step.results):
                _parts += ['{\\postdisplaypenalty=10000\n', str(step.relations), '\n}\n']
            elif step.relations:
                _parts += [str(step.relations), '\n']
            if step.results:
                _parts += [str(_known["locale"].hence), '\n', str(step.results), '\n']
        if (len(_known["steps"]) > 1):
            _parts += ['\\end{enumerate}\n']
    if _known["balances"]:
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].power), '}\n', str(_known["locale"].power_rule)]
        if _known["explained"]:
            _parts += [' ', str(_known["explained"])]
        _parts += ['\n']
        if _known["last"]:
            _parts += ['{\\postdisplaypenalty=10000\n', str(_known["balances"]), '\n}\n', str(_known["locale"].hence), '\n', str(_known["last"]), '\n']
        else:
            _parts += [str(_known["balances"]), '\n']
    for line in (_known["pictures"].bodies + _known["pictures"].plans):
        _parts += [str(line), '\n']
    _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].results), '}\n']
    for loop, result in turns(_known["results"]):
        if result.heading:
            _parts += ['\n\\medskip\n\\noindent\\textbf{', str(result.heading), ':}\n']
        for loop, paragraph in turns(result.paragraphs):
            _parts += [str(paragraph.sentence), '\n']
            if ((paragraph.equations and loop.last) and result.follows):
                _parts += ['{\\postdisplaypenalty=10000\n', str(paragraph.equations), '\n}\n']
            elif paragraph.equations:
                _parts += [str(paragraph.equations), '\n']
        if result.follows:
            _parts += ['\n\\noindent ', str(_known["locale"].hence), '\n']
        for loop, display in turns(result.displays):
            if (loop.last and result.is_remarked):
                _parts += ['{\\postdisplaypenalty=10000\n', str(display), '\n}\n']
            else:
                _parts += [str(display), '\n']
        for found in result.findings:
            if found.remarks:
                _parts += ['\\begin{itemize}\\setlength{\\itemsep}{0pt}\\setlength{\\parskip}{0pt}\n']
                for remark in found.remarks:
                    _parts += ['  \\item ', str(remark), '\n']
                _parts += ['\\end{itemize}\n']
            if found.derivatives:
                _parts += ['\\noindent ', str(found.sensitivities), ':\n', str(found.derivatives), '\n']
    for line in _known["pictures"].plot:
        _parts += [str(line), '\n']
    if _known["conditions"]:
        _parts += ['\\noindent ', str(_known["locale"].requirements), ' ', str(_known["conditions"]), '.\n']
    if (_known["values"] or _known["numbers"]):
        _parts += ['\n']
        if (_known["section"] == 'section'):
            _parts += ['\\lastsection\n']
        _parts += ['\\', str(_known["section"]), '*{', str(_known["locale"].numbers), '}\n', str(_known["locale"].at_default), ':\n']
        if _known["of_position"]:
            _parts += [str(', '.join(map(str, _known["of_position"]))), ';\n']
        if _known["values"]:
            _parts += [str(_known["values"]), '\n']
        if _known["numbers"]:
            if _known["values"]:
                _parts += ['\\noindent ']
            _parts += [str(', '.join(map(str, _known["numbers"]))), '.\n']
    _parts += ['\n\\nopagebreak\\medskip\n\\noindent ', str(_known["check"]), '\n']
    for remark in _known["remarks"]:
        _parts += [str(remark), '\n']
    _parts += ['\n']
    for line in _known["pictures"].table:
        _parts += [str(line), '\n']
    return "".join(_parts)


def _brief(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += [TEMPLATES['latex/head.jinja'](_known)]
    for display in _known["displays"]:
        _parts += [str(display), '\n']
    if (_known["values"] or _known["numbers"]):
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].numbers), '}\n', str(_known["locale"].at_default), ':\n', str(', '.join(map(str, _known["numbers"]))), '\n']
        if _known["values"]:
            _parts += [str(_known["values"]), '\n']
    return "".join(_parts)


def _coordinates_abreast(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\begin{longtable}[l]{@{}*{2}{>{\\raggedright\\arraybackslash}p{0.1\\linewidth}>{\\raggedright\\arraybackslash}p{0.33\\linewidth}}@{}}\n\\toprule\n', str(_known["locale"].vector), ' & ', str(_known["locale"].length), ' & ', str(_known["locale"].vector), ' & ', str(_known["locale"].length), ' \\\\\n\\midrule\n\\endhead\n']
    for loop, row in turns(_known["vectors"][:((len(_known["vectors"]) + 1) // 2)]):
        _parts += [str(row.vector), ' & ', str(row.length)]
        for loop, other in turns(_known["vectors"][(loop.length + loop.index0):(loop.length + loop.index)]):
            _parts += [' & ', str(other.vector), ' & ', str(other.length)]
        _parts += [' \\\\', str(('*' if (len(_known["vectors"]) < 32) else '')), '\n']
    _parts += ['\\bottomrule\n\\end{longtable}\n']
    return "".join(_parts)


def _given(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\begin{longtable}[l]{@{}>{\\raggedright\\arraybackslash}p{0.17\\linewidth}']
    if _known["labelled"]:
        _parts += ['>{\\raggedright\\arraybackslash}p{0.37\\linewidth}']
    _parts += ['>{\\raggedright\\arraybackslash}p{0.18\\linewidth}']
    if _known["ranged"]:
        _parts += ['>{\\raggedright\\arraybackslash}p{0.18\\linewidth}']
    _parts += ['@{}}\n\\toprule\n', str(_known["locale"].symbol)]
    if _known["labelled"]:
        _parts += [' & ', str(_known["locale"].quantity)]
    _parts += [' & ', str(_known["locale"].value)]
    if _known["ranged"]:
        _parts += [' & ', str(_known["locale"].range)]
    _parts += [' \\\\\n\\midrule\n\\endhead\n']
    for row in _known["parameters"]:
        _parts += [str(row.symbol)]
        if _known["labelled"]:
            _parts += [' & ', str(row.label)]
        _parts += [' & ', str(row.value)]
        if _known["ranged"]:
            _parts += [' & ', str(row.range)]
        _parts += [' \\\\', str(('*' if (len(_known["parameters"]) < 16) else '')), '\n']
    _parts += ['\\bottomrule\n\\end{longtable}\n']
    return "".join(_parts)


def _head(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['% ', str(_known["made_by"]), '\n% Needs amsmath, array, booktabs and longtable.\n']
    _parts += [TEMPLATES['latex/letters.jinja'](_known)]
    _parts += ['\\begin{center}\n  {\\large\\bfseries ', str(_known["title"]), '\\par}\n  \\smallskip\n  {', str(_known["kind"]), '\\par}\n']
    if _known["source"]:
        _parts += ['  {\\small ', str(_known["locale"].source), ': ', str(_known["source"]), '\\par}\n']
    _parts += ['\\end{center}\n']
    return "".join(_parts)


def _letters(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\providecommand{\\mechccyr}[1]{\\ifdefined\\Umathchar #1\\else{\\fontencoding{T2A}\\selectfont #1}\\fi}\n\\providecommand{\\mechcbarred}[1]{\\leavevmode\\rlap{\\kern0.05em\\raisebox{0.45ex}{-}}#1}\n\\providecommand{\\mechcchar}[3]{\\ifdefined\\Umathchar\\iffontchar\\font"#1 #2\\else #3\\fi\\else #3\\fi}\n']
    return "".join(_parts)


def _note(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    labelled = list([_one for _one in _known["parameters"] if _one.label])
    ranged = list([_one for _one in _known["parameters"] if _one.range])
    kind = _known["words"]['title']
    _parts += [TEMPLATES['latex/head.jinja']({**_known, "kind": kind, "labelled": labelled, "ranged": ranged})]
    if _known["parameters"]:
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["locale"].given), '}\n']
        _parts += [TEMPLATES['latex/given.jinja']({**_known, "kind": kind, "labelled": labelled, "ranged": ranged})]
    _parts += [TEMPLATES['latex/tables.jinja']({**_known, "kind": kind, "labelled": labelled, "ranged": ranged})]
    _parts += ['\n\\', str(_known["section"]), '*{', str(_known["words"]['lines']), '}\n']
    for line in _known["lines"]:
        if line.is_plain:
            _parts += ['\\noindent ', str(line.label), ': ', str(line.display), '\\par\n']
        else:
            if line.label:
                _parts += ['\\noindent ', str(line.label), ':\n']
            if line.remark:
                _parts += ['{\\postdisplaypenalty=10000\n', str(line.display), '\n}%\n']
            else:
                _parts += [str(line.display), '\n']
        if line.remark:
            _parts += ['\\noindent (', str(line.remark), ')\\par\\smallskip\n']
    if _known["unused"]:
        _parts += ['\\medskip\\noindent ', str(_known["unused"]), '\\par\n']
    if _known["checks"]:
        _parts += ['\n% A break that is left to TeX would come inside the table and print its heading twice.\n\\par\\penalty-100 \\ifdim\\dimexpr\\pagegoal-\\pagetotal<9\\baselineskip \\vfil\\break\\fi\n\\', str(_known["section"]), '*{', str(_known["words"]['checks']), '}\n\\begin{longtable}[l]{@{}>{\\raggedright\\arraybackslash}p{0.36\\linewidth}>{\\raggedright\\arraybackslash}p{0.3\\linewidth}>{\\raggedright\\arraybackslash}p{0.1\\linewidth}>{\\raggedright\\arraybackslash}p{0.16\\linewidth}@{}}\n\\toprule\n', str(_known["words"]['condition']), ' & ', str(_known["words"]['numbers']), ' & ', str(_known["words"]['reserve']), ' & ', str(_known["words"]['verdict']), ' \\\\\n\\midrule\n\\endhead\n']
        for check in _known["checks"]:
            _parts += [str(check.condition), ' & ', str(check.numbers), ' & ', str(check.reserve), ' & ', str(check.verdict), ' \\\\\n']
        _parts += ['\\bottomrule\n\\end{longtable}\n']
    return "".join(_parts)


def _notebook(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if _known["position"]:
        _parts += ['**', str(_known["locale"].position), '**\n\n']
        for loop, step in turns(_known["position"]):
            if (len(_known["position"]) > 1):
                _parts += [str(loop.index), '\\. ']
            _parts += [str(step.sentence), '\n\n', str('\n\n'.join(map(str, step.displays))), '\n\n']
    if _known["steps"]:
        _parts += ['**', str(_known["locale"].velocities), '**\n\n', str(_known["convention_of_speeds"]), '\n\n']
        for loop, step in turns(_known["steps"]):
            if (len(_known["steps"]) > 1):
                _parts += [str(loop.index), '\\. ']
            _parts += [str(step.sentence), '\n\n', str(step.relations), '\n\n']
            if step.results:
                _parts += [str(_known["locale"].hence), '\n\n', str(step.results), '\n\n']
    if _known["balances"]:
        _parts += ['**', str(_known["locale"].power), '**\n\n', str(_known["locale"].power_rule), ' ', str(_known["explained"]), '\n\n', str(_known["balances"]), '\n\n']
        if _known["last"]:
            _parts += [str(_known["locale"].hence), '\n\n', str(_known["last"]), '\n\n']
    _parts += ['**', str(_known["locale"].results), '**\n\n']
    for section in _known["results"]:
        if section.heading:
            _parts += ['*', str(section.heading), ':*\n\n']
        for paragraph in section.paragraphs:
            _parts += [str(paragraph.sentence), '\n\n', str(paragraph.equations), '\n\n']
        _parts += [str('\n\n'.join(map(str, section.displays))), '\n\n']
        for found in section.findings:
            for remark in found.remarks:
                _parts += ['- ', str(remark), '\n']
            _parts += ['\n']
    if _known["conditions"]:
        _parts += [str(_known["locale"].requirements), ' ', str(_known["conditions"]), '.\n\n']
    _parts += [str(_known["check"]), '\n']
    return "".join(_parts)


def _notebook_note(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if _known["parameters"]:
        _parts += ['| ', str(_known["locale"].symbol), ' | ', str(_known["locale"].quantity), ' | ', str(_known["locale"].value), ' | ', str(_known["locale"].range), ' |\n|---|---|---|---|\n']
        for row in _known["parameters"]:
            _parts += ['| ', str(row.symbol), ' | ', str(row.label), ' | ', str(row.value), ' | ', str(row.range), ' |\n']
        _parts += ['\n']
    for line in _known["lines"]:
        if line.is_plain:
            _parts += [str(line.label), ': ', str(line.display), '\n']
        else:
            if line.label:
                _parts += [str(line.label), ':\n\n']
            _parts += [str(line.display), '\n']
        _parts += ['\n']
        if line.remark:
            _parts += ['(', str(line.remark), ')\n\n']
    if _known["unused"]:
        _parts += [str(_known["unused"]), '\n\n']
    for check in _known["checks"]:
        _parts += ['- ', str(check.condition), ': ', str(check.numbers), ' (', str(check.verdict), ')\n']
    return "".join(_parts)


def _report(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\documentclass[10pt,a4paper]{article}\n\\usepackage{iftex}\n\\ifPDFTeX\n']
    if _known["eastern"]:
        _parts += ['  \\usepackage[T1,T2A]{fontenc}\n']
    elif _known["cyrillic"]:
        _parts += ['  \\usepackage[T2A,T1]{fontenc}\n  \\newcommand{\\mechccyr}[1]{{\\fontencoding{T2A}\\fontfamily{cmr}\\selectfont #1}}\n']
    else:
        _parts += ['  \\usepackage[T1]{fontenc}\n']
    _parts += ['  \\usepackage[utf8]{inputenc}\n']
    if (not _known["eastern"]):
        _parts += ['  \\IfFileExists{lmodern.sty}{\\usepackage{lmodern}}{}\n']
    _parts += ['\\else\n  \\usepackage[no-math]{fontspec}\n']
    if _known["cyrillic"]:
        _parts += ['  % The first of these fonts that is installed; all have Cyrillic letters.\n  \\IfFontExistsTF{cmunrm.otf}{\\setmainfont{cmunrm.otf}[BoldFont=cmunbx.otf,ItalicFont=cmunti.otf]}{%\n  \\IfFontExistsTF{Noto Serif}{\\setmainfont{Noto Serif}}{%\n  \\IfFontExistsTF{FreeSerif}{\\setmainfont{FreeSerif}}{%\n  \\IfFontExistsTF{Liberation Serif}{\\setmainfont{Liberation Serif}}{%\n  \\IfFontExistsTF{Times New Roman}{\\setmainfont{Times New Roman}}{%\n  \\IfFontExistsTF{DejaVu Serif}{\\setmainfont{DejaVu Serif}}{}}}}}}\n']
    _parts += ['\\fi\n']
    if _known["eastern"]:
        _parts += ['\\IfFileExists{', str(_known["babel"]), '.ldf}{\\usepackage[', str(_known["babel"]), ']{babel}}{}\n']
    _parts += ['\\usepackage[margin=22mm]{geometry}\n\\usepackage{amsmath}\n\\usepackage{array}\n\\usepackage{booktabs}\n\\usepackage{longtable}\n']
    for line in _known["pictures"]:
        _parts += [str(line), '\n']
    _parts += ['\\allowdisplaybreaks\n% Skips shrink where but a few lines would be left for a last page. A page is not filled for its heading.\n\\AtBeginDocument{%\n  \\abovedisplayskip=10pt plus 2pt minus 6pt\\belowdisplayskip=\\abovedisplayskip\n  \\abovedisplayshortskip=6pt plus 2pt minus 3pt\\belowdisplayshortskip=6pt plus 3pt minus 3pt\n  \\LTpre=12pt plus 4pt minus 8pt\\LTpost=\\LTpre\\medskipamount=6pt plus 2pt minus 4pt\n  \\lineskiplimit=2pt\\lineskip=3pt\\relax}\n\\tolerance=2000\n\\relpenalty=10000\n\\makeatletter\n\\renewcommand\\section{\\@startsection{section}{1}{\\z@}{-3.5ex plus -1ex minus -1.8ex}%\n  {2.3ex plus .2ex minus 1.2ex}{\\normalfont\\Large\\bfseries}}\n\\newcommand\\lastsection{\\@secpenalty=-20 }\n\\@fptop=0pt\\@beginparpenalty=10000 \\makeatother\n\\setlength{\\emergencystretch}{6em}\n\\begin{document}\n', str(_known["body"]), '\\end{document}\n']
    return "".join(_parts)


def _tables(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if _known["tables"]:
        _parts += ['\n\\', str(_known["section"]), '*{', str(_known["words"]['tables']), '}\n']
        for table in _known["tables"]:
            if table.name:
                _parts += ['\\noindent ', str(table.name)]
                if table.source:
                    _parts += [' (', str(table.source), ')']
                _parts += [':\\par\\nopagebreak\n']
            _parts += ['\\noindent\\begin{tabular}{@{}', str(table.columns), '@{}}\n\\toprule\n']
            for row in table.rows:
                _parts += [str(row), ' \\\\\n']
            _parts += ['\\bottomrule\n\\end{tabular}\\par\\medskip\n']
    return "".join(_parts)


def _used(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\clearpage\n\\', str(_known["section"]), '*{', str(_known["heading"]), '}\n\\noindent ', str(_known["sentence"]), '\\par\\medskip\n', str(_known["body"])]
    return "".join(_parts)


def _vectors_abreast(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\\begin{longtable}[l]{@{}*{2}{>{\\raggedright\\arraybackslash}p{0.08\\linewidth}>{\\raggedright\\arraybackslash}p{0.175\\linewidth}>{\\raggedright\\arraybackslash}p{0.155\\linewidth}}@{}}\n\\toprule\n', str(_known["locale"].vector), ' & ', str(_known["locale"].length), ' & ', str(_known["locale"].direction), ' & ', str(_known["locale"].vector), ' & ', str(_known["locale"].length), ' & ', str(_known["locale"].direction), ' \\\\\n\\midrule\n\\endhead\n']
    for loop, row in turns(_known["vectors"][:((len(_known["vectors"]) + 1) // 2)]):
        _parts += [str(row.vector), ' & ', str(row.length), ' & ', str(row.direction)]
        for loop, other in turns(_known["vectors"][(loop.length + loop.index0):(loop.length + loop.index)]):
            _parts += [' & ', str(other.vector), ' & ', str(other.length), ' & ', str(other.direction)]
        _parts += [' \\\\', str(('*' if (len(_known["vectors"]) < 32) else '')), '\n']
    _parts += ['\\bottomrule\n\\end{longtable}\n']
    return "".join(_parts)


TEMPLATES = {
    "latex/body.jinja": _body,
    "latex/brief.jinja": _brief,
    "latex/coordinates_abreast.jinja": _coordinates_abreast,
    "latex/given.jinja": _given,
    "latex/head.jinja": _head,
    "latex/letters.jinja": _letters,
    "latex/note.jinja": _note,
    "latex/notebook.jinja": _notebook,
    "latex/notebook_note.jinja": _notebook_note,
    "latex/report.jinja": _report,
    "latex/tables.jinja": _tables,
    "latex/used.jinja": _used,
    "latex/vectors_abreast.jinja": _vectors_abreast,
}
