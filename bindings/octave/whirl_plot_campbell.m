function handle = whirl_plot_campbell(result, varargin)
% WHIRL_PLOT_CAMPBELL  Draws the Campbell diagram of a result with modes: natural frequencies over the parameter.
%   WHIRL_PLOT_CAMPBELL(RESULT) draws the damped frequencies in the unit of the speed, or in Hz if the parameter is not
%   the speed. The dashed line is once a revolution (1X). Circles mark critical speeds, crosses thresholds of stability,
%   with their values. WHIRL_PLOT_CAMPBELL(RESULT, 'table', NAME) draws the table NAME, not the first with modes.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_BODE.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
result = result_of(result);
handle = draw_panel_of(result, figure_name(result, 'campbell', FIELD.modes_frequency, options.table), 'frequency');
end
