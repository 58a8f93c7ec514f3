# Writes OUT from IN with the commit of the sources at SOURCE, but only if the commit changed, so that nothing
# is compiled again needlessly. Run at each build: cmake -DSOURCE= -DIN= -DOUT= -P this.
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE THENAR_COMMIT
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(THENAR_COMMIT "")
endif()
configure_file(${IN} ${OUT} @ONLY)
