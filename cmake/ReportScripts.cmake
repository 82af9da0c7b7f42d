# foverig_report_scripts(TARGET): the scripts of the report, and uPlot with its licence from npm, as strings in TARGET.
# Where npm is absent or cannot fetch, the report keeps its static figures; removing the generated file tries again.
function(foverig_report_scripts target)
  set(web ${PROJECT_SOURCE_DIR}/rig/report/web)
  set(output ${PROJECT_BINARY_DIR}/generated/report_scripts.cpp)
  set(inline ${PROJECT_SOURCE_DIR}/cmake/InlineScripts.cmake)
  find_program(FOVERIG_NPM npm)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DNPM=${FOVERIG_NPM} -DWEB=${web} -DFOLDER=${PROJECT_BINARY_DIR}/report_web -DOUTPUT=${output} -P ${inline}
    DEPENDS ${inline} ${web}/package-lock.json ${web}/package.json ${web}/strip.js ${web}/magnifier.js
    VERBATIM COMMENT "report: uPlot from npm")
  target_sources(${target} PRIVATE ${output})
endfunction()
