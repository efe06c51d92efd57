/* Declares the functions of libwhirl that this package calls, in the subset of C that cffi reads. The test
   python.declarations compiles this file after the library's own headers, so that no declaration can differ from
   theirs. */
typedef struct whirl_case whirl_case;
typedef struct whirl_job whirl_job;
typedef struct whirl_result whirl_result;
typedef struct whirl_table whirl_table;
typedef struct whirl_columns whirl_columns;
typedef struct whirl_journal whirl_journal;
typedef struct whirl_point_store whirl_point_store;

const char *whirl_version(void);
whirl_status whirl_version_check(int major, int minor, int patch);

whirl_status whirl_case_check(const char *text, size_t length, const char *name, char *problems, size_t size,
                              whirl_case **out);
const char *whirl_case_text(const whirl_case *object, size_t *length);
const char *whirl_case_title(const whirl_case *object);
whirl_status whirl_case_set(whirl_case *object, const char *assignment);
whirl_status whirl_case_spend(whirl_case *object, double revolutions, double seconds);
whirl_status whirl_case_outline(const whirl_case *object, whirl_result **outline);
void whirl_case_free(whirl_case *object);

typedef void (*whirl_job_progress_fn)(void *context, const char *stage, double points_done, double points_total,
                                      double revolutions_done, double revolutions_total, double seconds);
whirl_status whirl_job_new(const whirl_case *object, whirl_job **job);
void whirl_job_free(whirl_job *job);
whirl_status whirl_job_threads(whirl_job *job, int threads);
void whirl_job_progress(whirl_job *job, whirl_job_progress_fn tell, void *context);
void whirl_job_keep(whirl_job *job, const whirl_point_store *store);
void whirl_job_stop(whirl_job *job);
whirl_status whirl_job_prepare(whirl_job *job);
whirl_status whirl_job_run(whirl_job *job, whirl_result **result);

typedef struct whirl_user_system whirl_user_system;
typedef int (*whirl_user_rates_fn)(double t, const double *x, const double *p, double *dxdt, void *context);
typedef int (*whirl_user_lanes_fn)(size_t count, size_t row, const double *t, const double *x, const double *p,
                                   double *dxdt, void *context);
typedef int (*whirl_user_tangent_fn)(double t, const double *x, const double *p, const double *dx, double *ddxdt,
                                     void *context);
whirl_status whirl_user_system_new(const char *title, size_t dimension, whirl_user_system **out);
void whirl_user_system_free(whirl_user_system *system);
whirl_status whirl_user_system_parameter(whirl_user_system *system, const char *name, double value, const char *unit,
                                         const char *text);
whirl_status whirl_user_system_start(whirl_user_system *system, size_t index, double value);
whirl_status whirl_user_system_station(whirl_user_system *system, const char *name, size_t x, size_t y, size_t vx,
                                       size_t vy);
whirl_status whirl_user_system_angle(whirl_user_system *system, size_t index, double period);
whirl_status whirl_user_system_scale(whirl_user_system *system, size_t index, double scale);
whirl_status whirl_user_system_oscillates(whirl_user_system *system, size_t displacements);
whirl_status whirl_user_system_rates(whirl_user_system *system, whirl_user_rates_fn rates, void *context);
whirl_status whirl_user_system_lanes(whirl_user_system *system, whirl_user_lanes_fn rates, void *context);
whirl_status whirl_user_system_tangent(whirl_user_system *system, whirl_user_tangent_fn tangent, void *context);
whirl_status whirl_user_system_period(whirl_user_system *system, double period);
whirl_status whirl_user_system_speed(whirl_user_system *system, const char *parameter);
whirl_status whirl_user_system_kinked(whirl_user_system *system);
whirl_status whirl_user_system_vary(whirl_user_system *system, const char *parameter, const double *values,
                                    size_t count);
whirl_status whirl_user_system_analyze(whirl_user_system *system, const char *analysis);
whirl_status whirl_user_system_set(whirl_user_system *system, const char *option, const char *value);
whirl_status whirl_user_system_branch(whirl_user_system *system, const char *parameter, double from, double to,
                                      const double *at, size_t count);
whirl_status whirl_user_system_curves(whirl_user_system *system, const char *parameter, double from, double to);
typedef double (*whirl_user_event_fn)(double t, const double *x, const double *p, void *context);
typedef int (*whirl_user_reset_fn)(double t, const double *x, const double *p, double *after, void *context);
whirl_status whirl_user_system_event(whirl_user_system *system, const char *name, whirl_user_event_fn value,
                                     int passing, whirl_user_reset_fn reset, int ends, void *context);
typedef struct whirl_user_motion whirl_user_motion;
whirl_status whirl_user_system_follow(const whirl_user_system *system, const double *times, size_t count,
                                      whirl_user_motion **out);
void whirl_user_motion_free(whirl_user_motion *motion);
const double *whirl_user_motion_states(const whirl_user_motion *motion, size_t *count);
size_t whirl_user_motion_events(const whirl_user_motion *motion);
int whirl_user_motion_event(const whirl_user_motion *motion, size_t index, size_t *which, double *time,
                            const double **before, const double **after);
int whirl_user_motion_end(const whirl_user_motion *motion, double *time, const char **words);
whirl_status whirl_user_system_identity(whirl_user_system *system, const char *identity);
whirl_status whirl_job_of_user_system(const whirl_user_system *system, whirl_job **job);
whirl_status whirl_user_system_outline(const whirl_user_system *system, whirl_result **outline);

whirl_status whirl_journal_begin(const char *path, const whirl_result *outline, whirl_journal **journal);
whirl_status whirl_journal_resume(const char *path, const whirl_result *outline, whirl_journal **journal);
const whirl_point_store *whirl_journal_store(whirl_journal *journal);
whirl_status whirl_journal_close(whirl_journal *journal);
whirl_status whirl_journal_remove(whirl_journal *journal);

whirl_status whirl_result_read(const char *path, whirl_result **result);
whirl_status whirl_result_read_outline(const char *path, whirl_result **outline);
whirl_status whirl_result_read_record(const char *path, whirl_result **result);
whirl_status whirl_result_read_record_columns(const char *path, const char *const *headings, const char *const *names,
                                              size_t count, whirl_result **result);
whirl_status whirl_columns_read(const char *path, const char *const *headings, const char *const *names, size_t count,
                                whirl_columns **columns);
size_t whirl_columns_count(const whirl_columns *columns);
size_t whirl_columns_rows(const whirl_columns *columns);
const char *whirl_columns_name(const whirl_columns *columns, size_t index);
const char *whirl_columns_unit(const whirl_columns *columns, size_t index);
const double *whirl_columns_numbers(const whirl_columns *columns, size_t index);
void whirl_columns_free(whirl_columns *columns);
whirl_status whirl_result_write(const whirl_result *result, const char *path);
whirl_status whirl_result_verify(const whirl_result *result, const char *path);
whirl_status whirl_result_add_fact(whirl_result *result, const char *name, const char *value);
whirl_status whirl_explorer_write(const char *template_path, const whirl_result *const *results,
                                  const char *const *names, size_t count, const char *directory);
void whirl_result_free(whirl_result *result);
const char *whirl_result_title(const whirl_result *result);
const char *whirl_result_case_name(const whirl_result *result);
const char *whirl_result_case_text(const whirl_result *result);
double whirl_result_speed(const whirl_result *result);
double whirl_result_force_scale(const whirl_result *result);
double whirl_result_length_scale(const whirl_result *result, const whirl_table *table, size_t point);
bool whirl_result_is_partial(const whirl_result *result);
size_t whirl_result_count(const whirl_result *result, whirl_list list);
const char *whirl_result_name(const whirl_result *result, whirl_list list, size_t index);
const char *whirl_result_text(const whirl_result *result, whirl_list list, size_t index, const char *what);
double whirl_result_number(const whirl_result *result, whirl_list list, size_t index, const char *what);
whirl_status whirl_result_show_in(whirl_result *result, const char *units);
const whirl_table *whirl_result_table(const whirl_result *result, const char *name);

const char *whirl_table_parameter(const whirl_table *table);
const char *whirl_table_varied(const whirl_table *table);
const char *whirl_table_stacked(const whirl_table *table);
const char *whirl_table_role(const whirl_table *table);
size_t whirl_table_points(const whirl_table *table);
size_t whirl_table_places(const whirl_table *table);
double whirl_table_clock(const whirl_result *result, const whirl_table *table, size_t point);
size_t whirl_table_place(const whirl_table *table, size_t point);
size_t whirl_table_row(const whirl_table *table);
size_t whirl_table_rows(const whirl_table *table);
size_t whirl_table_planes(const whirl_table *table);
size_t whirl_table_slot(const whirl_table *table, size_t point);
bool whirl_table_done(const whirl_table *table, size_t point);
const double *whirl_table_values(const whirl_table *table);
const int *whirl_table_branch(const whirl_table *table);
size_t whirl_table_field_count(const whirl_table *table);
const char *whirl_table_field_name(const whirl_table *table, size_t field);
const char *whirl_table_field_unit(const whirl_table *table, size_t field);
const char *whirl_table_field_meaning(const whirl_table *table, size_t field);
const char *whirl_table_field_extent(const whirl_table *table, size_t field);
size_t whirl_table_field_singles(const whirl_table *table, size_t field);
bool whirl_field_has_rows(const char *name);
double whirl_table_field_si(const whirl_result *result, const whirl_table *table, size_t field, char *name,
                            size_t size);
const double *whirl_table_column(const whirl_table *table, size_t field, size_t shape[3], size_t *stride);
whirl_status whirl_table_copy(const whirl_table *table, size_t field, double *numbers);
void whirl_table_words(const whirl_table *table, size_t point, char *name, char *reason, size_t size);
whirl_status whirl_table_attractor_numbers(const whirl_table *table, size_t *numbers, double *shares, double *errors);
const char *whirl_table_option(const whirl_table *table, size_t index, char *text, size_t size);
whirl_status whirl_result_figure_with(const whirl_result *result, const whirl_result *with, const char *name,
                                      const char *units, const char *panels, const char *log, char **json);
bool whirl_result_name_fits(const char *path);
whirl_status whirl_nearest_value(const whirl_result *result, const char *parameter, const double *values, size_t count,
                                 const char *text, size_t *index);
whirl_status whirl_result_figures(const whirl_result *result, const char *units, char **lines);
whirl_status whirl_result_findings(const whirl_result *result, const char *sheet, const char *units, const char *format,
                                   char **text);
whirl_status whirl_result_dataset(const whirl_result *result, const char *what, const char *name, char **text);
whirl_status whirl_result_sheets(const whirl_result *result, const char *units, char **lines);
whirl_status whirl_result_warnings(const whirl_result *result, const char *units, char **lines);
whirl_status whirl_balance_json(const char *text, size_t length, const char *name, const char *units, char *problems,
                                size_t size, char **json);
void whirl_text_free(char *text);
whirl_status whirl_bearing_json(const char *text, size_t length, const char *name, const char *units, int threads,
                                char *problems, size_t size, char **json, char **figures);

whirl_status whirl_signals_threshold(const double *voltage, size_t count, double *threshold, double *hysteresis);
whirl_status whirl_signals_pulses(const double *time, const double *voltage, size_t count, double threshold,
                                  double hysteresis, bool rising, double *instants, size_t *pulses);
whirl_status whirl_signals_speed(const double *instants, size_t pulses, double *speed);
whirl_status whirl_signals_section(const double *time, const double *values, size_t count, size_t channels,
                                   const double *instants, size_t pulses, double phase, int order, double *section,
                                   size_t *points);
whirl_status whirl_signals_samples(const double *time, size_t count, const double *instants, size_t pulses,
                                   size_t *samples);
whirl_status whirl_signals_resample(const double *time, const double *values, size_t count, size_t channels,
                                    const double *instants, size_t pulses, size_t samples, int order,
                                    double *resampled);
whirl_status whirl_signals_track(const double *resampled, size_t channels, size_t turns, size_t samples,
                                 const double *orders, size_t count, size_t revolutions, double *vectors);
whirl_status whirl_signals_axes(const double *u, const double *v, size_t count, double first, double second, double *x,
                                double *y);
whirl_status whirl_signals_angle(const double *instants, size_t pulses, const double *time, size_t count,
                                 double *angle);
whirl_status whirl_signals_vold_kalman_weight(double bandwidth, double rate, int poles, double *weight);
whirl_status whirl_signals_vold_kalman(const double *values, size_t count, double rate, const double *phases,
                                       size_t tracked, const double *bandwidths, int poles, double *amplitudes);
size_t whirl_signals_orders(size_t count, size_t samples, double highest_order);
whirl_status whirl_signals_spectrum(const double *x, const double *y, size_t count, size_t samples,
                                    double highest_order, double *orders, double *lines, size_t *line_count,
                                    double *synchronous);
size_t whirl_signals_frequencies(size_t window);
whirl_status whirl_signals_spectrogram(const double *x, const double *y, size_t count, size_t window, size_t step,
                                       double *rows);
whirl_status whirl_signals_sweep(double sweep, double *kept);
whirl_status whirl_signals_size(const double *values, size_t count, size_t channels, double *size);
whirl_status whirl_signals_zero_one(const double *points, size_t count, size_t dimension, double size, double *k);
whirl_status whirl_signals_returns(const double *points, size_t count, size_t dimension, double size, double tolerance,
                                   int *period, double *distance);
whirl_status whirl_signals_recurrence(const double *points, size_t count, size_t dimension, double radius,
                                      size_t shortest, double *rate, double *determinism, double *laminarity,
                                      size_t *longest);
whirl_status whirl_signals_rain_flow(const double *values, size_t count, double *cycles, size_t *rows);
whirl_status whirl_signals_damage(const double *cycles, size_t rows, const double *ranges, const double *lives,
                                  size_t points, double slope, double endurance, double *damage);
