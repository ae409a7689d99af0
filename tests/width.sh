#!/usr/bin/env bash
# Comments in Rust, C and C++, and the text of documents, have at most 140 characters in a line. Prints each longer line and fails.
# Rows of tables, code, pictures and lines with an address may be longer. An entry of CHANGELOG.md is one line; include/*.h are generated.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files '*.rs' '*.c' '*.h' '*.cpp' '*.hpp' '*.md' ':!CHANGELOG.md' ':!include/*.h' | xargs perl -CSD -ne '
    chomp;
    my ($mark, $rest) = m{^\s*(//[/!]?|/?\*|) ?(.*)};
    my $is_document = $ARGV =~ /\.md$/;
    $fenced = !$fenced if ($mark || $is_document) && $rest =~ /^\s*```/;
    $is_code = $fenced || ($is_document ? /^ {4}/ : !$mark) || $rest =~ /^(?:\||!\[)/;
    if (length > 140 && !$is_code && !m{://}) {
        print "$ARGV:$.: ", length, " characters\n";
        $is_long = 1;
    }
    if (eof) { close ARGV; $fenced = 0; }
    END { $? = $is_long ? 1 : 0 }
'
