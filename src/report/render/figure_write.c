// Writes a figure to a file: JSON, or a picture by gnuplot.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "gnuplot.h"
#include "gnuplot_script.h"
#include "report_file.h"
#include "whirl/engine/figure.h"
#include "whirl/status.h"

static whirl_status write_json(const whirl_figure *figure, const char *folder, const char *name) {
    report_file file;
    whirl_status status = report_file_open(&file, folder, name);
    if (status.code != WHIRL_OK) return status;
    status = whirl_figure_write_json(figure, file.stream);
    if (status.code == WHIRL_OK) return report_file_close(&file);
    report_file_drop(&file);
    return status;
}

/// Writes script and data to a folder, and draws the picture next to it.
static whirl_status figure_write_draw(const whirl_figure *figure, const char *folder, const char *format,
                                      const char *program) {
    report_file file;
    whirl_status status = report_file_open(&file, folder, "figure.dat");
    if (status.code != WHIRL_OK) return status;
    gnuplot_write_data(file.stream, figure);
    status = report_file_close(&file);
    if (status.code == WHIRL_OK) status = report_file_open(&file, folder, "figure.gp");
    if (status.code != WHIRL_OK) return status;
    gnuplot_write_script(file.stream, figure, "figure", "figure.dat", format);
    status = report_file_close(&file);
    gnuplot_job job = {.folder = folder, .script = "figure.gp"};
    if (status.code == WHIRL_OK) status = gnuplot_run(program, &job, 1);
    return status;
}

/// Returns an error with gnuplot's first message.
static whirl_status gnuplot_failure(const whirl_figure *figure, const char *folder) {
    char path[FILE_PATH_SIZE], line[200] = "";
    snprintf(path, sizeof path, "%.4000s/figure.gp.log", folder);
    FILE *log = fopen(path, "r");
    while (log && strspn(line, " \n\r\t^") == strlen(line) && fgets(line, sizeof line, log)) {
    }
    if (log) fclose(log);
    line[strcspn(line, "\n")] = '\0';
    return whirl_fail(WHIRL_IO_ERROR, "gnuplot could not draw %.100s: %.200s", figure->name, line);
}

static whirl_status write_drawn(const whirl_figure *figure, const char *path, const char *folder, const char *format,
                                const char *program) {
    static const char *const made[] = {"figure.dat", "figure.gp", "figure.gp.log", "figure.png", "figure.pdf",
                                       "figure.svg", NULL};
    char own[FILE_PATH_SIZE], picture[FILE_PATH_SIZE];
    whirl_status status = folder_make_temporary(folder, own);
    if (status.code != WHIRL_OK) return status;
    status = figure_write_draw(figure, own, format, program);
    if (status.code == WHIRL_IO_ERROR) status = gnuplot_failure(figure, own);
    if (status.code == WHIRL_MISSING_PROGRAM)
        status =
            whirl_fail(status.code, "%.200s is not there, by which figures are drawn (apt-get install gnuplot-nox)",
                       program ? program : "gnuplot");
    snprintf(picture, sizeof picture, "%.4000s/figure.%s", own, format);
    if (status.code == WHIRL_OK && rename(picture, path) != 0)
        status = whirl_fail(WHIRL_IO_ERROR, "%.200s cannot be written: %.100s", path, strerror(errno));
    folder_remove(own, made);
    return status;
}

whirl_status whirl_figure_write(const whirl_figure *figure, const char *path, const char *program) {
    static const char *const formats[] = {"png", "pdf", "svg"};
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path, *ending = strrchr(name, '.');
    char folder[FILE_PATH_SIZE];
    if (strlen(path) > 4000) return whirl_fail(WHIRL_IO_ERROR, "the path %.200s... is too long", path);
    snprintf(folder, sizeof folder, "%.*s", name == path ? 1 : (int)(name - path), name == path ? "." : path);
    if (ending && strcmp(ending, ".json") == 0) return write_json(figure, folder, name);
    for (size_t i = 0; ending && i < sizeof formats / sizeof *formats; i++)
        if (strcmp(ending + 1, formats[i]) == 0) return write_drawn(figure, path, folder, formats[i], program);
    return whirl_fail(WHIRL_BAD_INPUT, "%.200s ends in no format of figures, expected .png, .pdf, .svg or .json", path);
}
