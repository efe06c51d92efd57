function machine = whirl_machine(given_case, varargin)
% WHIRL_MACHINE  Builds the rotor of a case, for scripts that integrate its equations themselves.
%   M = WHIRL_MACHINE(CASE, NAME, VALUE, ...) builds the rotor of a case file, or of the text of a case, with
%   parameters or keys set as in WHIRL_RUN. M has the members stations (names), dimension (of the state), speed
%   (rad/s), length_scale (m).
%
%   WHIRL_MACHINE('clear', M) frees a machine, WHIRL_MACHINE('clear') all machines. At most 64 exist at a time.
%
%   See also WHIRL_RHS, WHIRL_ELEMENT.
if nargin > 0
    given_case = text_of(given_case);
end
if nargin < 1 || ~ischar(given_case)
    error('whirl:badInput', 'whirl_machine takes a case and pairs of names and values');
end
if strcmp(given_case, 'clear')
    machine = [];
    if nargin > 1
        whirl_mex('clear', number_of(varargin{1}));
    else
        whirl_mex('clear');
    end
    return
end
if mod(numel(varargin), 2) ~= 0
    error('whirl:badInput', 'whirl_machine takes a case and pairs of names and values');
end
text = given_case;
name = 'case';
if ~any(given_case == 10)
    text = '';   % the gateway reads the file
    name = given_case;
end
settings = cell(1, numel(varargin) / 2);
for i = 1:numel(settings)
    settings{i} = setting(varargin{2 * i - 1}, varargin{2 * i});
end
if exist('whirl_mex', 'file') ~= 3
    error('whirl:noGateway', ...
        'the gateway whirl_mex is not installed, which single elements need (docs/octave.md, Setting up)');
end
number = whirl_mex('machine', text, name, settings{:});
machine = whirl_mex('about', number);
machine.number = number;
end
