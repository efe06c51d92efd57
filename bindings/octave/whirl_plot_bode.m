function handle = whirl_plot_bode(result, varargin)
% WHIRL_PLOT_BODE  Draws the response to unbalance over the parameter: its amplitude, and its lag below.
%   Lines show both probes of a station (x and y, unless the case turns them) and the orbit's major axis.
%   WHIRL_PLOT_BODE(RESULT, STATION) draws the response of a station (name or number; default: the first) into two axes
%   of the current figure. WHIRL_PLOT_BODE(..., 'table', NAME) draws the table NAME, not the first with a response to
%   unbalance.
%
%   Returns a list of two: the handles of the series of the amplitude, and of the series of the lag (docs/figures.md).
%
%   See also WHIRL_PLOT_CAMPBELL.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[]}, struct('table', []));
result = result_of(result);
name = figure_name(result, 'unbalance', FIELD.unbalance_amplitude, options.table, places{1});
panels = {'amplitude', 'lag'};
places = {[0.16, 0.58, 0.8, 0.37], [0.16, 0.15, 0.8, 0.34]};
handle = cell(1, 2);
for i = 1:2
    half = subplot(2, 1, i);
    handle{i} = draw_panel_of(result, name, panels{i});
    set(half, 'Position', places{i});
    if i == 1
        xlabel(half, '');
    end
end
end
