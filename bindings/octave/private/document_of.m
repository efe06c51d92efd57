function found = document_of(name, file, what, folder, options)
% DOCUMENT_OF  Returns the JSON document that the command NAME prints for a file, decoded.
%   FILE is the name of a file, or a struct with its content, which is written into a temporary file in FOLDER, with a
%   version under the key NAME. WHAT names the kind of file in messages; OPTIONS follow the file in the command.
if ~isstruct(file) && ~is_text(text_of(file))
    error('whirl:badInput', 'whirl_%s takes the name of %s, or a struct with its content', name, what);
end
if ~isstruct(file)
    found = jsondecode(answer([name ' ' quoted(file_of(text_of(file))) ' --json' options]));
    return
end
if ~isfield(file, name)
    file.(name) = 1;
end
kept = [tempname(folder) '.yaml'];
stream = fopen(kept, 'w');
if stream < 0
    error('whirl:failed', 'cannot write %s, expected a folder that may be written to', kept);
end
fwrite(stream, jsonencode(file));   % JSON is YAML
fclose(stream);
try
    found = jsondecode(answer([name ' ' quoted(kept) ' --json' options]));
catch problem
    delete(kept);
    rethrow(problem);
end
delete(kept);
end
