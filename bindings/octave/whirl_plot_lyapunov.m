function handle = whirl_plot_lyapunov(result, varargin)
% WHIRL_PLOT_LYAPUNOV  Draws the largest Lyapunov exponent over the parameter with its standard error.
%   WHIRL_PLOT_LYAPUNOV(RESULT) draws it in the colours of the regimes, without the error if the table has no sections;
%   RESULT is a struct of WHIRL_READ or the name of a file. WHIRL_PLOT_LYAPUNOV(RESULT, 'table', NAME) draws the table
%   NAME, not the first with exponents.
%
%   Returns a handle for every series of the panel (docs/figures.md).
%
%   See also WHIRL_PLOT_BIFURCATION.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
result = result_of(result);
[table, name] = table_with(result, FIELD.lyapunov_largest, 'lyapunov', options.table);
if has_field(table, FIELD.poincare_section)
    handle = draw_panel_of(result, figure_name(result, 'bifurcation', '', name, []), 'exponent');
else
    handle = draw_panel_of(result, [name '/' FIELD.lyapunov_largest], 'value');
end
end
