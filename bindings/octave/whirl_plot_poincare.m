function handle = whirl_plot_poincare(result, varargin)
% WHIRL_PLOT_POINCARE  Draws the section of a point: the position of a station once a revolution.
%   WHIRL_PLOT_POINCARE(RESULT, POINT, STATION) draws y over x; POINT counts from 1, STATION is a name or a number.
%   WHIRL_PLOT_POINCARE(RESULT, [], STATION, 'at', VALUE) draws the point whose parameter is nearest to a value, and
%   'table', NAME chooses a table, as in WHIRL_PLOT_ORBIT.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_BIFURCATION, WHIRL_PLOT_ORBIT.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('at', [], 'table', []));
handle = draw_point(result, places, options, FIELD.poincare_section, 'poincare', 'section');
end
