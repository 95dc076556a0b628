// A condition without parentheses.
#ifdef A
#end
