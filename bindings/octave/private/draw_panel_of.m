function handle = draw_panel_of(result, name, panel, titled)
% DRAW_PANEL_OF  Draws a panel ('': the first) of a figure of a result into the current axes, with the title if TITLED.
%   Returns one handle for each series of docs/figures.md.
chosen = '';
if ~isempty(panel)
    chosen = [' --panels=' quoted(panel)];
end
data = jsondecode(answer(['figure ' quoted(file_of(result.attributes.file)) ' ' quoted(file_of(name)) chosen ' -o -']));
handle = draw_description(data, newplot(), nargin > 3 && titled);
end
