// The text of a directive is missing: the place is behind it.
#debug

sphere { 0, 1 }
