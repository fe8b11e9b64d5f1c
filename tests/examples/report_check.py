"""A report is one file: report_check.py PAGE [TEXT ...]

The page parses with every element closed, refers to no other file or address, has all pictures in itself as whole PNG
files, and shows each TEXT as text.
"""
import base64
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

VOID = {"meta", "img", "input", "br", "hr", "link"}
ADDRESSES = {"src", "href", "srcset", "data", "action", "poster", "background"}


class Page(HTMLParser):
    """Open elements, findings and pictures."""

    def __init__(self):
        super().__init__()
        self.open, self.findings, self.pictures, self.text = [], [], 0, ""

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ADDRESSES:
                self.check_address(tag, name, value or "")
            if name.startswith("on"):
                self.findings.append(f"<{tag}> has a handler {name}")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.findings.append(f"</{tag}> at {self.getpos()} closes another element")

    def handle_data(self, data):
        if self.open and self.open[-1] in ("style", "script"):
            if re.search(r"url\(|@import|https?:|fetch|XMLHttp", data):
                self.findings.append(f"<{self.open[-1]}> refers to something outside")
        else:
            self.text += data

    def check_address(self, tag, name, value):
        head = "data:image/png;base64,"
        if tag != "img" or name != "src" or not value.startswith(head):
            self.findings.append(f"<{tag} {name}> refers to {value[:60]}")
            return
        picture = base64.b64decode(value[len(head):], validate=True)
        if not picture.startswith(b"\x89PNG") or b"IEND" not in picture[-12:]:
            self.findings.append("a picture is no whole PNG file")
        self.pictures += 1


def main():
    page = Page()
    page.feed(Path(sys.argv[1]).read_text(encoding="utf-8"))
    page.close()
    findings = page.findings + [f"<{tag}> is not closed" for tag in page.open]
    findings += [f"the text '{text}' is missing" for text in sys.argv[2:] if text not in page.text]
    if page.pictures == 0:
        findings.append("there are no pictures")
    for finding in findings:
        print(finding)
    print(f"{page.pictures} pictures")
    return 1 if findings else 0


sys.exit(main())
