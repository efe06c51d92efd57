function handle = whirl_plot_waterfall(result, varargin)
% WHIRL_PLOT_WATERFALL  Draws the lines of all spectra over order and parameter, by colour.
%   WHIRL_PLOT_WATERFALL(RESULT, STATION) draws the lines of a station (name or number) down to a thousandth of the
%   largest: forward whirl at orders above 0, backward whirl below; of a sweep in both directions only the way up.
%   WHIRL_PLOT_WATERFALL(..., 'highest_order', N) leaves out orders above N. WHIRL_PLOT_WATERFALL(..., 'table', NAME)
%   draws the table NAME, not the first with spectra.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_SPECTRUM.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[]}, struct('highest_order', [], 'table', []));
most = options.highest_order;
if ~isempty(most) && (~isnumeric(most) || numel(most) ~= 1 || ~(most > 0))
    error('whirl:badInput', 'the option ''highest_order'' is a number above 0');
end
result = result_of(result);
handle = draw_panel_of(result, figure_name(result, 'waterfall', FIELD.spectrum_lines, options.table, places{1}), '');
if ~isempty(most)
    set(ancestor(handle(1), 'axes'), 'XLim', [-most, most]);
end
end
