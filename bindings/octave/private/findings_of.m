function found = findings_of(name, file, sheet, arguments)
% FINDINGS_OF  Returns the JSON of `whirl table` for a result, decoded.
%   NAME is the calling function for messages, FILE the name of a result or a struct of whirl_read, SHEET the name of a
%   sheet or '', ARGUMENTS the further arguments of the caller: 'units' and a text.
if isstruct(file)
    result = result_of(file);
    file = result.attributes.file;
end
if ~is_text(text_of(file))
    error('whirl:badInput', '%s takes the name of a result file, or what whirl_read gives', name);
end
[ignored, options] = arguments_of(arguments, {}, struct('units', '')); %#ok<ASGLU>
words = ['table ' quoted(file_of(text_of(file)))];
if ~isempty(sheet)
    words = [words ' ' quoted(file_of(sheet))];
end
if ~isempty(options.units)
    words = [words ' ' quoted(['--units=' text_of(options.units)])];
end
found = jsondecode(answer([words ' --format=json']));
end
