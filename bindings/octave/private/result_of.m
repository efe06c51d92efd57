function result = result_of(result)
% RESULT_OF  Returns a result whose figures can be drawn, from the struct of whirl_read or the name of its file.
result = text_of(result);
if ischar(result)
    result = whirl_read(result);
end
if ~isstruct(result) || ~isfield(result, 'attributes') || ~isfield(result.attributes, 'tables')
    error('whirl:badInput', 'expected a result: the name of a file, or what whirl_read gives');
end
if ~isfield(result.attributes, 'file')
    error('whirl:badInput', 'figures are drawn from a result file (.h5), which this result does not name');
end
if ~isequal(file_mark(result.attributes.file), result.attributes.file_mark)
    error('whirl:badInput', ['figures are drawn from the result file, and %s is gone or another one by now: ' ...
        'whirl_run with ''output'' keeps it'], result.attributes.file);
end
end
