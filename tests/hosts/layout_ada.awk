# Makes a program from sins.ads that prints its sizes, offsets and constants.

function show(label, value) {
    shown[++count] = "   Show (\"" label "\", " value ");"
}

BEGIN {
    print "with Ada.Text_IO; use Ada.Text_IO;\nwith Interfaces.C; use Interfaces.C;\nwith Sins; use Sins;"
    print "procedure Layout is\n   package Numbers is new Float_IO (double);"
    print "   procedure Show (Label : String; Value : double) is\n   begin"
    print "      Put (Label & \" \");\n      Numbers.Put (Value, Fore => 1, Aft => 16, Exp => 4);\n      New_Line;\n   end Show;"
}
/^   SINS_[A-Z0-9_]+ : constant / { show($1, $4 == "double" ? $1 : "double (" $1 ")") }
/^   type .* is record$/ {
    name = $2
    print "   Its_" name " : " name ";"
    show("sizeof(" name ")", "double (" name "'Size / 8)")
}
/^      [a-z0-9_]+ : / && name != "" {
    show(name "." $1, "double (Its_" name "." $1 "'Position)")
    show("sizeof(" name "." $1 ")", "double (Its_" name "." $1 "'Size / 8)")
}
/^   end record/ { name = "" }
END {
    print "begin"
    for (k = 1; k <= count; k++) print shown[k]
    print "end Layout;"
}
