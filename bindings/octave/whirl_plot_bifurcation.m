function handle = whirl_plot_bifurcation(result, varargin)
% WHIRL_PLOT_BIFURCATION  Draws a bifurcation diagram: sections over the parameter, in the colours of their regimes.
%   WHIRL_PLOT_BIFURCATION(RESULT) draws x of the first station once per revolution. RESULT is a struct of WHIRL_READ or
%   the name of a file. If points have several starts, every attractor is drawn once, in a colour of its own.
%   WHIRL_PLOT_BIFURCATION(RESULT, STATION, COORDINATE) draws a coordinate of a station (name or number); COORDINATE is
%   'x', 'y', 'vx', 'vy' (velocities, per radian of rotation), or its number. WHIRL_PLOT_BIFURCATION(..., 'table', NAME)
%   draws the table NAME, not the first with sections.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_READ, WHIRL_PLOT_POINCARE, WHIRL_PLOT_LYAPUNOV, WHIRL_PLOT_SHARES.
FIELD = field_names();
names = {'x', 'y', 'vx', 'vy'};
[places, options] = arguments_of(varargin, {[], 1}, struct('table', []));
result = result_of(result);
column = coordinate_index(places{2}, names);
if column > 2
    station = result.stations.name{station_index(result, places{1})};
    name = figure_name(result, [FIELD.poincare_section ':' station ':' names{column}], '', options.table);
    handle = draw_panel_of(result, name, 'value');
else
    name = figure_name(result, 'bifurcation', FIELD.poincare_section, options.table, places{1});
    handle = draw_panel_of(result, name, names{column});
end
end
