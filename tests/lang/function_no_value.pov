// What is no number has a sign, too.
#version 3.7;
#declare I = 1e308 * 10;
#debug concat(str(sin(I), 0, 2), " ", str(cos(-I), 0, 2), " ", str(tan(I), 0, 2), " ", str(pow(-8, 1/3), 0, 2), "\n")
#debug concat(str(acosh(0.5), 0, 2), " ", str(atanh(-2), 0, 2), " ", str(atanh(1), 0, 2), "\n")
#declare Acos = function(x) { acos(x) }
#declare Asin = function(x) { asin(x) }
#declare Acosh = function(x) { acosh(x) }
#declare Atanh = function(x) { atanh(x) }
#declare Ln = function(x) { ln(x) }
#declare Log = function(x) { log(x) }
#declare Root = function(x) { pow(x, 0.3) }
#declare Sin = function(x) { sin(x) }
#debug concat(str(Acos(2), 0, 2), " ", str(Asin(-2), 0, 2), " ", str(Acosh(0), 0, 2), " ", str(Atanh(2), 0, 2), "\n")
#debug concat(str(Ln(-2), 0, 2), " ", str(Log(-2), 0, 2), " ", str(Root(-2), 0, 2), " ", str(Sin(I), 0, 2), "\n")
