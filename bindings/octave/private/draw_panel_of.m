function handle = draw_panel_of(result, name, panel, titled)
% DRAW_PANEL_OF  Draws a panel of a figure of a result into the current axes, '' the first one; TITLED with the figure's
%   title.
%   Returns one handle for each series of docs/figures.md.
chosen = '';
if ~isempty(panel)
    chosen = [' --panels=' quoted(panel)];
end
data = jsondecode(answer(['figure ' quoted(file_of(result.attributes.file)) ' ' quoted(file_of(name)) chosen ' -o -']));
handle = draw_description(data, newplot(), nargin > 3 && titled);
end
