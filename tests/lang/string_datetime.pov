// datetime formats days since 2000 in Universal Time.
#version 3.7;
#debug concat(datetime(0), "\n", datetime(7000.5), "\n")
#debug concat(datetime(366, "%Y/%m/%d %j"), " ", datetime(1.000001, "%H:%M:%S"), "\n")
#debug concat(datetime(-1, "%A"), "\n")
